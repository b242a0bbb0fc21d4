#!/usr/bin/env python3
"""Launch files explain themselves, and what they name exists.

Every <arg> has a doc and a default; files, nodes, packages and the arguments of included files are
there; what Debian does not package is only looked for where an argument asks for it.
"""
import re
import xml.etree.ElementTree as ElementTree

from support.check import Case, run

PACKAGE = 'omega_slam'
FIND = re.compile(r'\$\(find (\w+)\)(/[\w./-]*)?')
NODE_TAGS = ('node', 'test')


def elements(parent, optional=False):
    """(element, whether an attribute "if" or "unless" may leave it out), through all depths."""
    for element in parent:
        here = optional or 'if' in element.attrib or 'unless' in element.attrib
        yield element, here
        yield from elements(element, here)


def declaredArguments(root):
    return {element.get('name'): element for element in root if element.tag == 'arg'}


def argumentFaults(root):
    for name, element in declaredArguments(root).items():
        if not element.get('doc', '').strip():
            yield f'arg {name} has no doc'
        if 'default' not in element.attrib and 'value' not in element.attrib:
            yield f'arg {name} has no default'
    names = [element.get('name') for element in root if element.tag == 'arg']
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f'arg {name} is there twice'


def usedArguments(text):
    """Names in $(arg name) and in arg('name')."""
    return set(re.findall(r"\$\(arg (\w+)\)|\barg\('(\w+)'\)", text))


def undeclaredFaults(root, text):
    declared = set(declaredArguments(root))
    used = {first or second for first, second in usedArguments(text)}
    for name in sorted(used - declared):
        yield f'arg {name} is used but not declared'
    for name in sorted(declared - used):
        yield f'arg {name} is declared but not used'


def findFaults(tree, element, optional, known):
    for value in element.attrib.values():
        for package, path in FIND.findall(value):
            if package == PACKAGE:
                if path and not (tree.source / path.lstrip('/')).exists():
                    yield f'{path.lstrip("/")} does not exist'
            elif package not in known and not optional:
                yield f'package {package} is not in package.xml, and no arg says whether it is there'


def isProgram(tree, name):
    places = [f'src/nodes/{name}.cpp', f'src/tools/{name}.cpp', f'scripts/{name}']
    return any((tree.source / place).is_file() for place in places) or any(
        path.name == name for path in tree.files('test/**/*'))


def nodeFaults(tree, element, optional, known):
    package, program = element.get('pkg', ''), element.get('type', '')
    if package == PACKAGE and not isProgram(tree, program):
        yield f'{element.tag} {element.get("name")}: there is no program {program}'
    if package != PACKAGE and package not in known and not optional:
        yield f'package {package} is not in package.xml, and no arg says whether it is there'


def includeFaults(tree, element):
    match = re.fullmatch(r'\$\(find omega_slam\)/([\w./-]+)', element.get('file', ''))
    if not match or not (tree.source / match.group(1)).is_file():
        return
    declared = declaredArguments(ElementTree.parse(tree.source / match.group(1)).getroot())
    for argument in element.findall('arg'):
        if argument.get('name') not in declared:
            yield f'{match.group(1)} has no arg {argument.get("name")}'


def fileFaults(tree, path, known):
    text = path.read_text()
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        yield f'not well-formed: {error}'
        return
    if path.suffix == '.launch':
        yield from argumentFaults(root)
    yield from undeclaredFaults(root, text)
    for element, optional in elements(root):
        yield from findFaults(tree, element, optional, known)
        if element.tag in NODE_TAGS:
            yield from nodeFaults(tree, element, optional, known)
        if element.tag == 'include':
            yield from includeFaults(tree, element)


def check(tree):
    manifest = ElementTree.fromstring((tree.source / 'package.xml').read_text())
    known = {element.text for element in manifest if element.tag.endswith('depend')}
    for path in tree.files('launch/**/*.launch', 'test/rostest/*.test'):
        for fault in fileFaults(tree, path, known):
            yield f'{tree.relative(path)}: {fault}'
    for path in tree.files('urdf/*.urdf', 'package.xml'):
        try:
            ElementTree.parse(path)
        except ElementTree.ParseError as error:
            yield f'{tree.relative(path)}: not well-formed: {error}'


def launch(content, **others):
    return {'package.xml': '<package><depend>rviz</depend></package>',
            'src/nodes/mapper.cpp': '', 'launch/b.launch': '<launch/>',
            'launch/a.launch': f'<launch>{content}</launch>', **others}


ARG = '<arg name="a" default="1" doc="words"/><param name="p" value="$(arg a)"/>'
CASES = [
    Case(launch(ARG + '<node pkg="omega_slam" type="mapper" name="m"/>'
                '<node pkg="rviz" type="rviz" name="r"/>'
                '<include file="$(find omega_slam)/launch/b.launch"/>'
                '<include if="$(arg a)" file="$(find turtlebot_bringup)/x.launch"/>')),
    Case(launch('<arg name="a" default="1"/>'), ('a has no doc',)),
    Case(launch('<arg name="a" doc="words"/>'), ('a has no default',)),
    Case(launch(ARG + ARG), ('a is there twice',)),
    Case(launch('<param name="p" value="$(arg b)"/>'), ('b is used but not declared',)),
    Case(launch('<param name="p" value="$(eval arg(\'b\') == 1)"/>'), ('b is used but not',)),
    Case(launch('<arg name="a" default="1" doc="words"/>'), ('a is declared but not used',)),
    Case(launch('<node pkg="omega_slam" type="mopper" name="m"/>'), ('no program mopper',)),
    Case(launch('<node pkg="urg_node" type="urg_node" name="u"/>'), ('urg_node is not in',)),
    Case(launch('<include file="$(find other)/a.launch"/>'), ('other is not in',)),
    Case(launch('<rosparam file="$(find omega_slam)/config/a.yaml"/>'), ('config/a.yaml does not',)),
    Case(launch('<include file="$(find omega_slam)/launch/b.launch"><arg name="x" value="1"/>'
                '</include>'), ('b.launch has no arg x',)),
    Case(launch('<group>'), ('not well-formed',)),
    Case(launch('', **{'urdf/robot.urdf': '<robot>'}), ('robot.urdf: not well-formed',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
