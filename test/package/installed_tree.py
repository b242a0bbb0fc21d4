#!/usr/bin/env python3
"""What `cmake --install` leaves works by itself: programs run, ROS finds the package, others link it.

Installs into a temporary folder, so it needs a build that is done. By DESTDIR, since catkin puts the
setup files below the prefix of the configuration, whatever --prefix says.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from support.check import Case, Skip, run

SHARED_FOLDERS = ('config', 'launch', 'maps', 'urdf')
CONSUMER_CMAKE = '''cmake_minimum_required(VERSION 3.16)
project(consumer CXX)
find_package(omega_slam REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer omega_slam::omega_slam)
'''
CONSUMER_CPP = '''#include <omega_slam/slam/back_end.h>
int main() { return omega_slam::slam::BackEnd{}.mapFromOdometry().isFinite() ? 0 : 1; }
'''


def execute(command, **options):
    """(exit code, all that was said)"""
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False, timeout=600, **options)
    return result.returncode, result.stdout


def lastLines(text):
    return ' / '.join(text.strip().split('\n')[-3:])


def fileFaults(tree, prefix, share):
    """What lies in the package's folders and headers, but not where it is installed."""
    for folder in SHARED_FOLDERS:
        for path in tree.files(f'{folder}/**/*'):
            if not (share / tree.relative(path)).is_file():
                yield f'{tree.relative(path)} is not installed'
    for path in tree.files('src/omega_slam/**/*.h'):
        if not (prefix / 'include' / path.relative_to(tree.source / 'src')).is_file():
            yield f'{tree.relative(path)} is not installed'


def programFaults(tree, programs, with_ros):
    """Every tool answers --help; every node is there."""
    for source in tree.files('src/tools/*.cpp'):
        code, said = executeIfThere([programs / source.stem, '--help'])
        if code != 0 or '--help' not in said:
            yield f'{source.stem} --help ended with {code}: {lastLines(said)}'
    for source in tree.files('src/nodes/*.cpp') if with_ros else []:
        if not os.access(programs / source.stem, os.X_OK):
            yield f'node {source.stem} is not installed'


def executeIfThere(command):
    if not os.access(command[0], os.X_OK):
        return 127, f'{command[0].name} is not installed'
    return execute(command)


def rosEnvironment(prefix):
    """As after sourcing the setup file of the installed tree, and of nothing else."""
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(('ROS_', 'CMAKE_', 'PYTHON', 'LD_'))}
    environment['PATH'] = '/usr/bin:/bin'
    code, said = execute(['bash', '-c', f'. {prefix}/setup.bash && env -0'], env=environment)
    if code != 0:
        raise RuntimeError(f'setup.bash: {said}')
    return dict(entry.split('=', 1) for entry in said.split('\0') if '=' in entry)


def unconditionalNodes(launch_file):
    """(package, program) of nodes that no argument can leave out."""
    root = ElementTree.parse(launch_file).getroot()
    for element in root:
        if element.tag == 'node' and not {'if', 'unless'} & set(element.attrib):
            yield element.get('pkg'), element.get('type')


def rosFaults(share, prefix):
    environment = rosEnvironment(prefix)
    code, said = execute(['rospack', 'find', 'omega_slam'], env=environment)
    if said.strip() != str(share):
        yield f'rospack finds {said.strip()}, not {share}'
    code, said = execute(['python3', '-c', 'import omega_slam.msg, omega_slam.srv'],
                         env=environment)
    if code != 0:
        yield f'the messages can not be imported: {lastLines(said)}'
    nodes = set()
    for path in sorted((share / 'launch').glob('*.launch')):
        code, said = execute(['roslaunch', '--files', 'omega_slam', path.name], env=environment)
        outside = [line for line in said.split() if 'omega_slam' in line
                   and not line.startswith(str(prefix))]
        if code != 0 or outside or path.name not in said:
            yield f'roslaunch --files {path.name} ended with {code}: {lastLines(said)}'
        nodes.update(unconditionalNodes(path))
    for package, program in sorted(nodes):
        find = f'import sys, roslib.packages as p; sys.exit(not p.find_node("{package}", "{program}"))'
        if execute(['python3', '-c', find], env=environment)[0] != 0:
            yield f'a launch file starts {package}/{program}, which ROS does not find'


def linkFaults(prefix):
    """A package of somebody else finds the library by CMake and links it."""
    with tempfile.TemporaryDirectory() as folder:
        consumer = pathlib.Path(folder)
        (consumer / 'CMakeLists.txt').write_text(CONSUMER_CMAKE)
        (consumer / 'consumer.cpp').write_text(CONSUMER_CPP)
        for command in (['cmake', '-S', consumer, '-B', consumer / 'build',
                         f'-DCMAKE_PREFIX_PATH={prefix}', '-DPYTHON_EXECUTABLE=/usr/bin/python3'],
                        ['cmake', '--build', consumer / 'build'], [consumer / 'build/consumer']):
            code, said = execute(command)
            if code != 0:
                yield f'{pathlib.Path(command[0]).name} of a consumer failed: {lastLines(said)}'
                return


def installedFaults(tree, prefix, with_ros):
    share = prefix / 'share/omega_slam'
    programs = prefix / ('lib/omega_slam' if with_ros else 'bin')
    yield from fileFaults(tree, prefix, share)
    yield from programFaults(tree, programs, with_ros)
    if with_ros:
        yield from rosFaults(share, prefix)
    yield from linkFaults(prefix)


def configuredPrefix(tree):
    cache = (tree.build / 'CMakeCache.txt').read_text()
    return pathlib.Path(re.search(r'^CMAKE_INSTALL_PREFIX:\w+=(.*)$', cache, re.MULTILINE).group(1))


def check(tree):
    if not (tree.build / 'cmake_install.cmake').exists():
        raise Skip('nothing was built')
    with tempfile.TemporaryDirectory() as folder:
        destination = pathlib.Path(folder).resolve()
        prefix = destination / configuredPrefix(tree).relative_to('/')
        code, said = execute(['cmake', '--install', tree.build],
                             env=dict(os.environ, DESTDIR=str(destination)))
        if code != 0:
            yield f'cmake --install ended with {code}: {lastLines(said)}'
            return
        yield from installedFaults(tree, prefix, tree.builtWithRos())


def checkPretended(tree):
    """For the self-test: a tree in which the folder `prefix` is what was installed."""
    prefix = tree.source / 'prefix'
    for path in (prefix / 'bin').glob('*'):
        path.chmod(0o755)
    pretended = type(tree)(tree.source / 'package', tree.build)
    yield from fileFaults(pretended, prefix, prefix / 'share/omega_slam')
    yield from programFaults(pretended, prefix / 'bin', with_ros=True)


def installed(**others):
    tool = '#!/bin/sh\necho "--help: this"\n'
    files = {'package/launch/a.launch': '<launch/>', 'package/src/omega_slam/a/a.h': '\n',
             'package/src/tools/tool.cpp': '\n', 'package/src/nodes/node.cpp': '\n',
             'prefix/share/omega_slam/launch/a.launch': '<launch/>',
             'prefix/include/omega_slam/a/a.h': '\n', 'prefix/bin/tool': tool,
             'prefix/bin/node': tool}
    return {name: text for name, text in {**files, **others}.items() if text is not None}


CASES = [
    Case(installed()),
    Case(installed(**{'prefix/share/omega_slam/launch/a.launch': None}), ('a.launch is not',)),
    Case(installed(**{'prefix/include/omega_slam/a/a.h': None}), ('a.h is not installed',)),
    Case(installed(**{'prefix/bin/tool': None}), ('tool is not installed',)),
    Case(installed(**{'prefix/bin/tool': '#!/bin/sh\nexit 3\n'}), ('tool --help ended with 3',)),
    Case(installed(**{'prefix/bin/node': None}), ('node node is not installed',)),
]

if __name__ == '__main__':
    run(__doc__, checkPretended if '--self-test' in sys.argv else check, CASES)
