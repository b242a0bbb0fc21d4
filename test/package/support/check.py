"""What the checks of the package share: finding files, reporting, and proving that a check can fail.

A check is a function of a Tree that yields sentences, one for each fault. Its self-test is a list of
Case: a small tree of files, and words that must come up when the check looks at it.
"""
import argparse
import dataclasses
import pathlib
import sys
import tempfile

SKIPPED = 77
NOT_OURS = {'.git', '.cache', 'build', 'devel', 'install', 'results', '__pycache__'}


class Skip(Exception):
    """Raised where a check has nothing to look at; the text says why."""


@dataclasses.dataclass
class Tree:
    """The package, and the folder that it was built in."""
    source: pathlib.Path
    build: pathlib.Path

    def files(self, *patterns):
        """Files of the package that match a pattern such as 'src/**/*.h', sorted."""
        found = {path for pattern in patterns for path in self.source.glob(pattern)}
        return sorted(path for path in found
                      if path.is_file() and not NOT_OURS & set(self.relative(path).parts))

    def texts(self):
        """All text files of the package."""
        return [path for path in self.files('**/*', '**/.*') if isText(path)]

    def cpp(self):
        return self.files('src/**/*.h', 'src/**/*.cpp', 'test/**/*.h', 'test/**/*.cpp',
                          'benchmark/**/*.h', 'benchmark/**/*.cpp')

    def relative(self, path):
        return path.relative_to(self.source)

    def builtWithRos(self):
        return 'WITH_ROS:BOOL=ON' in (self.build / 'CMakeCache.txt').read_text()


@dataclasses.dataclass
class Case:
    """Files (path to text) and what the check must say of them; nothing: that they are in order."""
    files: dict
    expected: tuple = ()


def isText(path):
    return b'\0' not in path.read_bytes()[:8192]


def makeTree(folder, files):
    tree = Tree(pathlib.Path(folder) / 'source', pathlib.Path(folder) / 'build')
    tree.source.mkdir()
    tree.build.mkdir()
    for name, text in files.items():
        path = tree.source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tree


def selfTestFaults(check, cases):
    """What the check overlooked, or made up."""
    for number, case in enumerate(cases, start=1):
        with tempfile.TemporaryDirectory() as folder:
            said = list(check(makeTree(folder, case.files)))
        if not case.expected and said:
            yield f'case {number} is in order, but the check says: {said}'
        for words in case.expected:
            if not any(words in sentence for sentence in said):
                yield f'case {number}: nothing about "{words}" in {said}'


def run(description, check, cases):
    """Command line of a check. Ends the program: 0 in order, 1 faults, 77 skipped."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument('--source-dir', type=pathlib.Path, required=True)
    parser.add_argument('--build-dir', type=pathlib.Path, required=True)
    parser.add_argument('--self-test', action='store_true',
                        help='run the check on small trees with known faults')
    arguments = parser.parse_args()
    tree = Tree(arguments.source_dir.resolve(), arguments.build_dir.resolve())
    if not cases:
        sys.exit('A check without a self-test proves nothing.')
    try:
        faults = list(selfTestFaults(check, cases) if arguments.self_test else check(tree))
    except Skip as reason:
        print(f'Skipped: {reason}')
        sys.exit(SKIPPED)
    for fault in faults:
        print(fault)
    print(f'{len(faults)} faults.' if faults else 'In order.')
    sys.exit(1 if faults else 0)
