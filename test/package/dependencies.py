#!/usr/bin/env python3
"""package.xml and scripts/dependencies.txt name the same dependencies, and CMake asks for no more."""
import re
import xml.etree.ElementTree as ElementTree

from support.check import Case, run

TOOL = 'tool:'


def readList(text):
    """(line number, Debian package, what it serves) of each entry."""
    for number, line in enumerate(text.split('\n'), start=1):
        words = line.split('#')[0].split(maxsplit=1)
        if words:
            yield number, words[0], words[1].strip() if len(words) > 1 else ''


def manifestKeys(text):
    root = ElementTree.fromstring(text)
    return [element.text.strip() for element in root if element.tag.endswith('depend')]


def catkinComponents(text):
    """Packages that CMake has catkin look for."""
    match = re.search(r'find_package\(catkin REQUIRED COMPONENTS([^)]*)\)', text)
    return match.group(1).split() if match else []


def listFaults(entries, keys):
    seen = set()
    for number, package, served in entries:
        place = f'scripts/dependencies.txt:{number}: {package}'
        if package in seen:
            yield f'{place} is listed twice'
        seen.add(package)
        if served.startswith(TOOL):
            if not served[len(TOOL):].strip():
                yield f'{place} does not say what the tool is for'
        elif served not in keys:
            yield f'{place} serves "{served}", which package.xml does not name'


def check(tree):
    keys = manifestKeys((tree.source / 'package.xml').read_text())
    entries = list(readList((tree.source / 'scripts/dependencies.txt').read_text()))
    yield from listFaults(entries, set(keys))
    served = {what for _, _, what in entries}
    for key in keys:
        if key not in served:
            yield f'package.xml: no package of scripts/dependencies.txt serves {key}'
        if keys.count(key) > 1:
            yield f'package.xml names {key} twice'
    for path in tree.files('cmake/*.cmake', 'CMakeLists.txt'):
        for component in catkinComponents(path.read_text()):
            if component not in keys:
                yield f'{tree.relative(path)} asks for {component}, which package.xml does not name'


def files(manifest, listed, cmake=''):
    return {'package.xml': f'<package format="3">{manifest}</package>\n',
            'scripts/dependencies.txt': '# Comment\n' + listed, 'cmake/a.cmake': cmake}


FMT = '<depend>fmt</depend>'
CASES = [
    Case(files(FMT, 'libfmt-dev fmt\n\ng++  tool: compiles\n')),
    Case(files(FMT, 'libfmt-dev  fmt\nlibfmt9  fmt\n')),
    Case(files(FMT + '<test_depend>gtest</test_depend>', 'libfmt-dev fmt\n'), ('serves gtest',)),
    Case(files('', 'libfmt-dev fmt\n'), ('which package.xml does not name',)),
    Case(files(FMT, 'libfmt-dev fmt\nxvfb\n'), ('xvfb serves ""',)),
    Case(files(FMT, 'libfmt-dev fmt\nxvfb tool:\n'), ('does not say what',)),
    Case(files(FMT, 'libfmt-dev fmt\nlibfmt-dev fmt\n'), ('listed twice',)),
    Case(files(FMT + FMT, 'libfmt-dev fmt\n'), ('twice',)),
    Case(files(FMT, 'libfmt-dev fmt\n', 'find_package(catkin REQUIRED COMPONENTS\n  fmt tf2)\n'),
         ('asks for tf2',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
