#!/usr/bin/env python3
"""Files and functions stay small: files up to 500 lines, functions up to 40 lines of code.

Beyond 350 lines a file is named as a warning, which is no fault.
"""
import re

from support.check import Case, run

FILE_WARNING = 350
FILE_LIMIT = 500
FUNCTION_LIMIT = 40
# A definition as clang-format lays it out: it ends in "{", and its end is a "}" of equal indent.
NOT_A_FUNCTION = re.compile(r'^\s*(namespace|class|struct|enum|union|if|for|while|switch|do|else|try'
                            r'|catch|case|default|return|extern)\b')
OPENING = re.compile(r'^(\s*).*\)\s*(const|noexcept|override|final|\s|->[\w:<>,\s&*]+)*'
                     r'(:.*)?\{$')


def codeLines(lines):
    """Lines that hold more than a comment or blanks."""
    return sum(1 for line in lines if line.strip() and not line.strip().startswith('//'))


def firstLineOfHead(lines, number):
    """Where the definition begins whose "{" ends line `number`: arguments and initialisers wrap."""
    def unopened(line):
        return line.count(')') - line.count('(')

    balance = unopened(lines[number])
    while number > 0 and (balance > 0 or lines[number].lstrip().startswith(':') or
                          lines[number - 1].endswith(',')):
        number -= 1
        balance += unopened(lines[number])
    return number


def functions(lines):
    """(first line's number, head, lines of code) of each function that spans lines."""
    for number, line in enumerate(lines):
        opening = OPENING.match(line)
        if not opening or NOT_A_FUNCTION.match(line):
            continue
        start = firstLineOfHead(lines, number)
        if NOT_A_FUNCTION.match(lines[start]):
            continue
        indent = re.match(r'\s*', lines[start]).group()
        for end in range(number + 1, len(lines)):
            if lines[end].startswith(indent + '}'):
                yield start + 1, lines[start].strip(), codeLines(lines[number + 1:end])
                break


def check(tree):
    for path in tree.cpp() + tree.files('scripts/**/*', 'test/**/*.py', 'cmake/*'):
        lines = path.read_text(errors='replace').split('\n')
        place = tree.relative(path)
        if len(lines) - 1 > FILE_LIMIT:
            yield f'{place}: {len(lines) - 1} lines, at most {FILE_LIMIT}'
        elif len(lines) - 1 > FILE_WARNING:
            print(f'Warning: {place} has {len(lines) - 1} lines; think of two files.')
        if path.suffix not in ('.h', '.cpp') or tree.relative(path).parts[0] != 'src':
            continue
        for number, head, size in functions(lines):
            if size > FUNCTION_LIMIT:
                yield f'{place}:{number}: {size} lines of code in {head}, at most {FUNCTION_LIMIT}'


def functionOf(size, head='int f(int a) {'):
    return head + '\n' + '  a += 1;\n' * size + '}\n'


CASES = [
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT)}),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT).replace('a += 1;\n', 'a += 1;\n\n  // Why.\n')}),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT) + functionOf(FUNCTION_LIMIT)}),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT + 1)}, ('41 lines of code in int f(int a)',)),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT + 1, 'int A::f(int a,\n         int b) const {')},
         ('41 lines of code in int A::f(int a,',)),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT, 'int aLongName(\n    int a, int b) {') +
          functionOf(FUNCTION_LIMIT)}),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT + 1, 'A::A(int a) : a_(a) {')}, ('41 lines',)),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT + 1, 'A::A(int a)\n    : a_(a),\n      b_(a) {')},
         ('41 lines of code in A::A(int a)',)),
    Case({'src/a.cpp': functionOf(FUNCTION_LIMIT, 'A::A(int a)\n    : a_(a),\n      b_(a) {') +
          functionOf(2)}),
    Case({'src/a.h': 'namespace a {\n' + functionOf(30) + functionOf(30) + '}\n'}),
    Case({'test/a.cpp': '// Line.\n' * FILE_LIMIT}),
    Case({'test/a.cpp': '// Line.\n' * (FILE_LIMIT + 1)}, ('501 lines',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
