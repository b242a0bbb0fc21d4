#!/usr/bin/env python3
"""The worlds in maps/ are what scripts/generate_worlds draws, to the byte."""
import pathlib
import subprocess
import sys
import tempfile

from support.check import Case, run

GENERATOR = 'scripts/generate_worlds'
SUFFIXES = ('.pgm', '.yaml')


def drawn(tree, folder):
    """The files of a fresh drawing by name, and what the generator said if it failed."""
    result = subprocess.run([sys.executable, str(tree.source / GENERATOR), '--out', folder],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False)
    if result.returncode != 0:
        return {}, result.stdout.strip().split('\n')[-1]
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}, ''


def check(tree):
    with tempfile.TemporaryDirectory() as folder:
        fresh, failure = drawn(tree, folder)
    if failure:
        yield f'{GENERATOR} failed: {failure}'
        return
    shipped = {path.name: path.read_bytes() for path in tree.files('maps/*')
               if path.suffix in SUFFIXES}
    for name in sorted({*fresh, *shipped}):
        if name not in shipped:
            yield f'maps/{name} is missing: run {GENERATOR}'
        elif name not in fresh:
            yield f'maps/{name} is not drawn by {GENERATOR}'
        elif fresh[name] != shipped[name]:
            yield f'maps/{name} is not what {GENERATOR} draws'


DRAWS_A = '''import pathlib, sys
(pathlib.Path(sys.argv[2]) / 'a.yaml').write_text('a\\n')
'''
CASES = [
    Case({GENERATOR: DRAWS_A, 'maps/a.yaml': 'a\n', 'maps/README.md': 'Words.\n'}),
    Case({GENERATOR: DRAWS_A, 'maps/a.yaml': 'b\n'}, ('maps/a.yaml is not what',)),
    Case({GENERATOR: DRAWS_A}, ('maps/a.yaml is missing',)),
    Case({GENERATOR: DRAWS_A, 'maps/a.yaml': 'a\n', 'maps/b.pgm': 'b\n'},
         ('maps/b.pgm is not drawn',)),
    Case({GENERATOR: "raise ValueError('no pen')\n"}, ('failed: ValueError: no pen',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
