#!/usr/bin/env python3
"""scripts/test counts right: a made-up project with every way that a test can end."""
import pathlib
import subprocess
import tempfile

from support.check import Case, run

PROJECT = '''cmake_minimum_required(VERSION 3.16...3.25)
project(made_up NONE)
enable_testing()
add_test(NAME "a/Suite.Case" COMMAND true)
add_test(NAME "a/All/Suite.Case/0 # GetParam() = 1.5 ... x" COMMAND true)
add_test(NAME "a/fails" COMMAND sh -c "echo words of the failed; false")
add_test(NAME "a/aborts" COMMAND sh -c "kill -ABRT $$")
add_test(NAME "a/dies" COMMAND sh -c "kill -TERM $$")
add_test(NAME "a/crashes" COMMAND sh -c "kill -SEGV $$")
add_test(NAME "a/is_slow" COMMAND sleep 5)
add_test(NAME "a/is_missing" COMMAND /no/such/program)
add_test(NAME "a/is_off" COMMAND true)
add_test(NAME "a/skips" COMMAND sh -c "exit 77")
set_tests_properties("a/is_slow" PROPERTIES TIMEOUT 1)
set_tests_properties("a/is_off" PROPERTIES DISABLED ON)
set_tests_properties("a/skips" PROPERTIES SKIP_RETURN_CODE 77)
'''
FAILED = ('a/fails', 'a/aborts', 'a/dies', 'a/crashes', 'a/is_slow', 'a/is_missing')
# In a folder of its own: common.sh makes build/logs beside the scripts that it belongs to.
SCRIPT = '''set -euo pipefail
for part in common build run_tests; do source "$1/scripts/lib/$part.sh"; done
jobs=2
filter=$3
watch_tests "$2" "$2/log"
report_tests "$filter"
'''


def count(scripts, project, text, filter_=''):
    """(exit code, lines said) of the scripts about a project with this CMakeLists.txt"""
    project.mkdir()
    (project / 'CMakeLists.txt').write_text(text)
    build = project / 'build'
    subprocess.run(['cmake', '-S', project, '-B', build], check=True, stdout=subprocess.DEVNULL)
    result = subprocess.run(['bash', '-c', SCRIPT, 'bash', scripts, build, filter_], text=True,
                            check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return result.returncode, result.stdout.strip().split('\n')


def faultsOf(what, said, code, summary):
    if (code, said[-1]) != (0 if ' 0 failed' in summary else 1, summary):
        yield f'{what}: "{summary}" was due, but it ends with {code} and "{said[-1]}"'


def check(tree):
    with tempfile.TemporaryDirectory() as folder:
        scripts = pathlib.Path(folder) / 'package'
        (scripts / 'scripts/lib').mkdir(parents=True)
        for path in tree.files('scripts/lib/*.sh'):
            (scripts / 'scripts/lib' / path.name).write_bytes(path.read_bytes())
        code, said = count(scripts, pathlib.Path(folder) / 'all', PROJECT)
        yield from faultsOf('every way to end', said, code, '2 passed, 6 failed, 2 skipped')
        for name in FAILED:
            if not any(f"-R '^{name}$'" in line for line in said):
                yield f'no command runs {name} again'
        if not any('words of the failed' in line for line in said):
            yield 'a failed test is not heard'
        code, said = count(scripts, pathlib.Path(folder) / 'some', PROJECT, 'Suite')
        yield from faultsOf('a filter', said, code, '2 passed, 0 failed')
        code, said = count(scripts, pathlib.Path(folder) / 'none', PROJECT, 'no_such_test')
        yield from faultsOf('a filter that matches nothing', said, code, '0 passed, 1 failed')
        code, said = count(scripts, pathlib.Path(folder) / 'empty', PROJECT.split('add_test')[0])
        yield from faultsOf('no tests at all', said, code, '0 passed, 1 failed')


def scriptsThat(say, leave):
    return {'scripts/lib/common.sh': '', 'scripts/lib/build.sh': '',
            'scripts/lib/run_tests.sh': f'watch_tests() {{ {say}; }}\nreport_tests() {{ {leave}; }}\n'}


CASES = [
    Case(scriptsThat('echo all is well', 'echo "12 passed, 0 failed"'),
         ('every way to end:', 'no command runs a/crashes', 'not heard', 'a filter:',
          'a filter that matches nothing:', 'no tests at all:')),
    Case(scriptsThat('echo words of the failed', 'echo "2 passed, 6 failed, 2 skipped"; exit 0'),
         ('every way to end:',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
