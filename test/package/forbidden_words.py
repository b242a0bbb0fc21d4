#!/usr/bin/env python3
"""Nothing of the machine that the package was written on: no paths of it, no private hosts."""
import pathlib
import re

from support.check import Case, run

# Addresses that are the world's, and may be linked to, end in these.
PUBLIC_SUFFIXES = ('.org', '.com', '.net', '.io', '.edu', '.de', '.fr', '.example')
# Split, so that this file passes its own check.
PATTERNS = [
    (re.compile(r'/(home|Users)' r'/\w+'), 'a home directory'),
    (re.compile(r'(?<![\w.])/ro' r'ot\b'), "root's home directory"),
    (re.compile(r'\b(10|192\.168|172\.(1[6-9]|2\d|3[01]))' r'(\.\d{1,3}){2,3}\b'),
     'a private address'),
]
URL = re.compile(r'\bhttps?://([\w.-]+)')
LOCAL_HOSTS = {'localhost', '127.0.0.1'}


def hostFaults(line):
    for host in URL.findall(line):
        name = host.rstrip('.').lower()
        if name not in LOCAL_HOSTS and not name.endswith(PUBLIC_SUFFIXES):
            yield f'host {host} is not a public one'
        if 'registry' in name or 'mirror' in name or 'proxy' in name:
            yield f'host {host} is of a registry'


def lineFaults(line, checkout):
    for pattern, what in PATTERNS:
        match = pattern.search(line)
        if match:
            yield f'{what}: {match.group()}'
    if re.search(re.escape(checkout) + r'(?![\w-])', line):
        yield f'the path of the checkout: {checkout}'
    yield from hostFaults(line)


def check(tree):
    # A package that lies directly below / or /opt would find its path in honest sentences.
    checkout = str(tree.source) if len(tree.source.parts) > 2 else str(pathlib.Path('/', '\0'))
    for path in tree.texts():
        for number, line in enumerate(path.read_text(errors='replace').split('\n'), start=1):
            for fault in lineFaults(line, checkout):
                yield f'{tree.relative(path)}:{number}: {fault}'


CASES = [
    Case({'README.md': 'See https://www.ros.org/reps/rep-0105.html and http://localhost:11311\n'}),
    Case({'a.txt': 'cd /home' '/ann/omega_slam\n'}, ('a home directory',)),
    Case({'a.txt': 'ls /ro' 'ot/x\n'}, ("root's home",)),
    Case({'a.txt': 'ssh 192.168' '.1.20\n'}, ('a private address',)),
    Case({'a.txt': 'http:' '//packages.lan/x\n'}, ('not a public one',)),
    Case({'a.txt': 'https:' '//registry.example/\n'}, ('of a registry',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
