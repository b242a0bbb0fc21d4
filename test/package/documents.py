#!/usr/bin/env python3
"""What the documents name exists: files behind links, and the commands between ``` fences."""
import re

from support.check import Case, run

LINK = re.compile(r'!?\[[^\]]*\]\(([^)\s]+)\)')
FENCE = re.compile(r'^```[^\n]*\n(.*?)^```', re.MULTILINE | re.DOTALL)
# Programs that commands in the documents may begin with, beside those of the package.
KNOWN_PROGRAMS = {'catkin_make', 'clang-format-14', 'cmake', 'ctest', 'roslaunch', 'rosrun',
                  'rosservice', 'source'}


def anchorsOf(text):
    """Anchors that headings give on the usual hosts of documents."""
    heads = re.findall(r'^#+ (.*)$', text, re.MULTILINE)
    return {re.sub(r'[^\w\- ]', '', head.lower()).replace(' ', '-') for head in heads}


def linkFaults(path, text):
    for target in LINK.findall(FENCE.sub('', text)):
        if re.match(r'\w+:', target):
            continue
        name, _, anchor = target.partition('#')
        file = path.parent / name if name else path
        if not file.exists():
            yield f'links to {target}, which does not exist'
        elif anchor and file.suffix == '.md' and anchor not in anchorsOf(file.read_text()):
            yield f'links to {target}, but there is no such heading'


def commands(text):
    """Lines of fenced blocks that look like commands, without their comments."""
    for block in FENCE.findall(text):
        for line in block.split('\n'):
            words = line.split(' #')[0].split()
            if words and re.fullmatch(r'[\w./-]+', words[0]) and (
                    words[0] in KNOWN_PROGRAMS or words[0].startswith('scripts/')):
                yield words


def isProgram(tree, name):
    places = (f'src/nodes/{name}.cpp', f'src/tools/{name}.cpp', f'scripts/{name}')
    return any((tree.source / place).is_file() for place in places)


def scriptFaults(tree, words):
    script = tree.source / words[0]
    if not script.is_file():
        yield f'{words[0]} does not exist'
        return
    known = script.read_text()
    for option in words[1:]:
        if option.startswith('--') and not re.search(re.escape(option) + r'\b', known):
            yield f'{words[0]} has no option {option}'


def launchFaults(tree, words):
    words = [word for word in words[1:] if not word.startswith('--')]
    if len(words) < 2 or words[0] != 'omega_slam':
        return
    file = tree.source / 'launch' / words[1]
    if not file.is_file():
        yield f'launch/{words[1]} does not exist'
        return
    for word in words[2:]:
        name = word.split(':=')[0]
        if ':=' in word and f'<arg name="{name}"' not in file.read_text():
            yield f'launch/{words[1]} has no arg {name}'


def commandFaults(tree, words):
    if words[0].startswith('scripts/'):
        yield from scriptFaults(tree, words)
    elif words[0] == 'roslaunch':
        yield from launchFaults(tree, words)
    elif words[0] == 'rosrun' and words[1] == 'omega_slam' and not isProgram(tree, words[2]):
        yield f'there is no program {words[2]}'


def check(tree):
    for path in tree.files('*.md', 'docs/**/*.md', '*.rst'):
        text = path.read_text()
        faults = list(linkFaults(path, text))
        for words in commands(text):
            faults += commandFaults(tree, words)
        for fault in faults:
            yield f'{tree.relative(path)}: {fault}'


def document(text):
    return {'README.md': text, 'docs/a.md': '# The head, of `it`\n', 'src/tools/tool.cpp': '\n',
            'scripts/run': 'case --fast) ;;\n',
            'launch/a.launch': '<launch><arg name="x" default="1" doc="words"/></launch>'}


CASES = [
    Case(document('[a](docs/a.md) [b](docs/a.md#the-head-of-it) [c](https://www.ros.org)\n'
                  '```\nscripts/run --fast  # words\nrosrun omega_slam tool --help\n'
                  'roslaunch omega_slam a.launch x:=2\n```\n')),
    Case(document('[a](docs/b.md)\n'), ('docs/b.md, which does not exist',)),
    Case(document('![a](docs/b.png)\n'), ('docs/b.png, which does not exist',)),
    Case(document('[a](docs/a.md#tail)\n'), ('no such heading',)),
    Case(document('```\nscripts/walk\n```\n'), ('scripts/walk does not exist',)),
    Case(document('```\nscripts/run --slow\n```\n'), ('no option --slow',)),
    Case(document('```\nrosrun omega_slam fool\n```\n'), ('no program fool',)),
    Case(document('```\nroslaunch omega_slam b.launch\n```\n'), ('b.launch does not exist',)),
    Case(document('```\nroslaunch omega_slam a.launch y:=2\n```\n'), ('has no arg y',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
