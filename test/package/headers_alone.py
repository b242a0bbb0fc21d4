#!/usr/bin/env python3
"""Every header compiles alone, so that the order of #include lines never matters.

Uses the compiler and the flags that the build uses. What has compiled is remembered in the build
folder by a hash of all that went in, so that only what has changed is compiled again.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess

from support.check import Case, Skip, run

CACHE = 'headers_alone.json'
OPTIONS_WITH_VALUE_TO_DROP = {'-o', '-MF', '-MT', '-MQ'}
OPTIONS_TO_DROP = {'-c', '-MD', '-MMD'}


def compileCommands(tree):
    """Source folder below the package -> flags that the build compiles a file of it with."""
    path = tree.build / 'compile_commands.json'
    if not path.exists():
        raise Skip(f'{path} is not there')
    commands = {}
    for entry in json.loads(path.read_text()):
        source = (tree.build / entry['directory'] / entry['file']).resolve()
        if tree.source in source.parents:
            commands[str(tree.relative(source))] = syntaxOnly(shlex.split(entry['command']))
    return commands


def syntaxOnly(words):
    """A compiler's command line without its outputs, its input and a cache before it."""
    if pathlib.Path(words[0]).name == 'ccache':
        words = words[1:]
    kept = []
    skip_next = False
    for word in words[:-1]:
        if skip_next or word in OPTIONS_WITH_VALUE_TO_DROP:
            skip_next = not skip_next
        elif word not in OPTIONS_TO_DROP:
            kept.append(word)
    return kept + ['-fsyntax-only']


def commandFor(header, commands):
    """The flags of a source as near to the header as there is: below the same top folders."""
    def kinship(source):
        return len(os.path.commonpath([str(header.parent), str(pathlib.Path(source).parent)]))
    best = max(commands, key=kinship, default=None)
    return commands[best] if best and kinship(best) > 0 else None


def textsIncluded(text, folders, seen):
    """The package's own headers that a text includes, and those that they include."""
    for line in text.split('\n'):
        if not line.startswith('#include "'):
            continue
        name = line.split('"')[1]
        for folder in folders:
            path = folder / name
            if path.is_file() and path not in seen:
                seen.add(path)
                textsIncluded(path.read_text(), folders, seen)
    return seen


def fingerprint(tree, header, command):
    folders = [tree.source / 'src', tree.source / 'test']
    paths = [header, *sorted(textsIncluded(header.read_text(), folders, set()))]
    # Messages turn into headers.
    paths += tree.files('msg/*.msg', 'srv/*.srv')
    content = '\0'.join([*command, *(path.read_text() for path in paths)])
    return hashlib.sha256(content.encode()).hexdigest()


def compilerSays(header, command):
    """The first complaint of the compiler, or nothing."""
    source = f'#include "{header}"\n'
    result = subprocess.run([*command, '-x', 'c++', '-'], input=source, text=True, check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode == 0:
        return ''
    lines = [line for line in result.stdout.split('\n') if 'error:' in line]
    return lines[0] if lines else result.stdout


def readCache(path):
    try:
        return set(json.loads(path.read_text()))
    except (OSError, ValueError):
        return set()


def check(tree):
    commands = compileCommands(tree)
    cache_path = tree.build / CACHE
    known = readCache(cache_path)
    good = set()
    tasks = []
    for header in tree.files('src/**/*.h', 'test/**/*.h'):
        command = commandFor(tree.relative(header), commands)
        if command is None:
            continue  # a part that this build leaves out
        key = fingerprint(tree, header, command)
        if key in known:
            good.add(key)
        else:
            tasks.append((header, command, key))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = list(pool.map(lambda task: compilerSays(*task[:2]), tasks))
    good.update(key for (_, _, key), complaint in zip(tasks, said) if not complaint)
    cache_path.write_text(json.dumps(sorted(good)))
    for (header, _, _), complaint in zip(tasks, said):
        if complaint:
            yield f'{tree.relative(header)} does not compile alone: {complaint}'


def built(files):
    """The files of a case, with what CMake would have written of its build beside them."""
    entry = {'directory': '.', 'file': '../source/src/a.cpp',
             'command': 'c++ -std=c++17 -c -o a.o ../source/src/a.cpp'}
    return {**files, 'src/a.cpp': '\n', '../build/compile_commands.json': json.dumps([entry])}


CASES = [
    Case(built({'src/a.h': '#pragma once\n#include <vector>\nstd::vector<int> f();\n'})),
    Case(built({'src/a.h': '#pragma once\nstd::vector<int> f();\n'}), ('does not compile alone',)),
    Case(built({'src/a.h': '#pragma once\n#include "b.h"\n', 'src/b.h': 'Missing f();\n'}),
         ('a.h does not', 'b.h does not')),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
