#!/usr/bin/env python3
"""Sources lie as clang-format 14 lays them; no file has tabs, trailing blanks or a ragged end."""
import os
import shutil
import subprocess

from support.check import Case, Skip, run

CLANG_FORMAT = 'clang-format-14'
FILES_PER_CALL = 50


def misformatted(tree):
    paths = tree.cpp()
    for start in range(0, len(paths), FILES_PER_CALL):
        batch = [str(path) for path in paths[start:start + FILES_PER_CALL]]
        # As an environment variable, a locale would change the language of the output.
        result = subprocess.run([CLANG_FORMAT, '--dry-run', '--style=file', *batch],
                                stderr=subprocess.PIPE, text=True, check=False,
                                env=dict(os.environ, LC_ALL='C'))
        for line in result.stderr.splitlines():
            if 'clang-format-violations' in line:
                yield line.split(': warning:')[0]


def formatFaults(tree):
    by_file = {}
    for place in misformatted(tree):
        path, line, _ = place.rsplit(':', 2)
        by_file.setdefault(path, []).append(line)
    for path, lines in sorted(by_file.items()):
        yield f'{path}:{lines[0]}: not as {CLANG_FORMAT} -i would leave it'


def blankFaults(tree):
    for path in tree.texts():
        text = path.read_text(errors='replace')
        place = tree.relative(path)
        for number, line in enumerate(text.split('\n'), start=1):
            if line != line.rstrip():
                yield f'{place}:{number}: blanks at the end of the line'
            if '\t' in line:
                yield f'{place}:{number}: a tab'
        if text and not text.endswith('\n'):
            yield f'{place}: no end of line at the end of the file'
        if text.endswith('\n\n'):
            yield f'{place}: blank lines at the end of the file'


def check(tree):
    if not shutil.which(CLANG_FORMAT):
        raise Skip(f'{CLANG_FORMAT} is not installed')
    yield from formatFaults(tree)
    yield from blankFaults(tree)


STYLE = {'.clang-format': 'BasedOnStyle: Google\n'}
CASES = [
    Case({**STYLE, 'src/a.cpp': 'int f() { return 1; }\n', 'README.md': 'Words.\n'}),
    Case({**STYLE, 'src/a.cpp': 'int f(){return 1;}\n'}, ('a.cpp:1: not as',)),
    Case({**STYLE, 'README.md': 'Words. \n'}, ('blanks at the end',)),
    Case({**STYLE, 'scripts/run': 'if true; then\n\techo\nfi\n'}, ('a tab',)),
    Case({**STYLE, 'README.md': 'Words.'}, ('no end of line',)),
    Case({**STYLE, 'README.md': 'Words.\n\n'}, ('blank lines',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
