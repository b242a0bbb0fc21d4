#!/usr/bin/env python3
"""Every third-party header included is there after installing scripts/dependencies.txt.

A machine that has more installed hides what the list lacks: this asks dpkg which package a header
comes from, and whether the list leads to it. Headers of packages in scripts/contestants.txt are
optional: CMake does without them.
"""
import re
import shutil
import subprocess

from support.check import Case, Skip, run

INCLUDE = re.compile(r'^\s*#\s*include\s*<([^>]+)>', re.MULTILINE)


def query(*arguments):
    return subprocess.run(['dpkg-query', *arguments], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout


def names(relations):
    """Package names of a field such as "a (>= 1), b:any | c"."""
    found = re.split(r'[,|]', relations)
    return {re.sub(r'[\s(:].*', '', name.strip()) for name in found if name.strip()}


def installedPackages():
    """Installed package, real or provided -> names of what it depends on."""
    needs = {}
    layout = '${Package}\t${Provides}\t${Pre-Depends},${Depends}\n'
    for line in query('-W', '-f', layout).splitlines():
        package, provides, depends = line.split('\t')
        for name in {package, *names(provides)}:
            needs.setdefault(name, set()).update(names(depends) | {package})
    return needs


def reachable(packages, needs):
    """All that is installed once `packages` are."""
    seen = set()
    waiting = list(packages)
    while waiting:
        name = waiting.pop()
        if name in needs and name not in seen:
            seen.add(name)
            waiting.extend(needs[name])
    return seen


def ownersOf(headers):
    """Header -> packages with a file of that name."""
    owners = {header: set() for header in headers}
    for line in query('-S', *(f'*/{header}' for header in headers)).splitlines():
        packages, _, path = line.rpartition(': ')
        for header in headers:
            if path.endswith('/' + header):
                owners[header] |= names(packages)
    return owners


def listed(path):
    """Packages of a list; none where it is not there."""
    lines = path.read_text().splitlines() if path.is_file() else []
    return [line.split()[0] for line in lines if line.strip() and not line.startswith('#')]


def check(tree):
    if not shutil.which('dpkg-query'):
        raise Skip('this is not Debian')
    users = {}
    for path in tree.cpp():
        for header in INCLUDE.findall(path.read_text()):
            users.setdefault(header, tree.relative(path))
    installed = reachable(listed(tree.source / 'scripts/dependencies.txt'), installedPackages())
    optional = set(listed(tree.source / 'scripts/contestants.txt'))
    for header, owners in sorted(ownersOf(sorted(users)).items()):
        if owners and not owners & (installed | optional):
            yield (f'{users[header]} includes <{header}> of {" or ".join(sorted(owners))}, '
                   'which scripts/dependencies.txt does not lead to')


def including(listed, *headers):
    text = ''.join(f'#include <{header}>\n' for header in headers)
    return {'src/a.cpp': text, 'scripts/dependencies.txt': f'# Words\n\n{listed} key\n'}


CASES = [
    Case(including('g++', 'vector', 'no/such/header.h')),
    Case(including('libsuitesparse-dev', 'suitesparse/cholmod.h')),
    Case({**including('g++', 'Eigen/Core'), 'scripts/contestants.txt': 'libeigen3-dev  why\n'}),
    Case(including('g++', 'vector', 'Eigen/Core'), ('<Eigen/Core> of libeigen3-dev',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
