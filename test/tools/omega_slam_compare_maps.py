#!/usr/bin/env python3
"""omega_slam_compare_maps from the outside: what it says and draws, its exit codes, its refusals."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ''
YAML = ('image: {}\nresolution: 0.1\norigin: [{}, {}, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n'
        'free_thresh: 0.196\n')
WALL, OPEN, UNKNOWN = 0, 254, 205


def building():
    """Rows from the top, of grey values: three rooms and some furniture, without any symmetry."""
    cells = [[WALL if y in (0, 59) or x in (0, 79) else OPEN for x in range(80)]
             for y in range(60)]
    for y in range(1, 40):
        cells[y][30] = WALL
    for x in range(30, 70):
        cells[25][x] = WALL
    for left, top, width, height in ((8, 8, 6, 3), (50, 5, 3, 9), (40, 45, 12, 4), (12, 40, 4, 4),
                                     (60, 32, 2, 2), (20, 20, 3, 6), (70, 50, 5, 3)):
        for y in range(top, top + height):
            for x in range(left, left + width):
                cells[y][x] = WALL
    return cells


class CompareMapsTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.truth = self.write('truth', building())

    def write(self, name, cells, origin=(0.0, 0.0)):
        pixels = bytes(value for row in cells for value in row)
        (self.folder / f'{name}.pgm').write_bytes(
            b'P5\n%d %d\n255\n' % (len(cells[0]), len(cells)) + pixels)
        path = self.folder / f'{name}.yaml'
        path.write_text(YAML.format(f'{name}.pgm', *origin))
        return path

    def run_(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              capture_output=True, timeout=120, check=False)

    def compare(self, built, *arguments):
        result = self.run_(built, self.truth, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    @staticmethod
    def row(said, name):
        """The numbers of one alignment."""
        line, = re.findall(rf'^{name} +([0-9].*)$', said, re.MULTILINE)
        return [float(field) for field in line.replace('/', ' ').split()]

    def testAMapResemblesItself(self):
        said = self.compare(self.truth, '--pose', 0, 0, 0)
        self.assertEqual(self.row(said, 'pose'), [1, 1, 100, 100, 100, 100, 100, 0, 0, 0])
        self.assertGreater(self.row(said, 'correlation')[0], 0.999)

    def testFindsAMapThatWasMovedAndTurned(self):
        cells = building()
        turned = [[cells[y][79 - x] for y in range(60)] for x in range(80)]  # to the left
        said = self.compare(self.write('built', turned, (-3.0, 7.0)))
        for name, close in (('correlation', 0.01), ('sift', 0.1)):
            if name == 'sift' and 'SIFT is not in this OpenCV' in said:
                continue
            numbers = self.row(said, name)
            self.assertGreater(numbers[0], 0.99)
            self.assertAlmostEqual(numbers[7], -7.0, delta=close)
            self.assertAlmostEqual(numbers[8], 3.0, delta=close)
            self.assertAlmostEqual(numbers[9], -90.0, delta=0.5)

    def testCountsWhatIsWrong(self):
        cells = building()
        for y in range(30, 50):
            cells[y][60] = WALL  # invented
        for x in range(31, 70):
            cells[25][x] = OPEN  # lost
        said = self.compare(self.write('built', cells), '--pose', 0, 0, 0, '--align', 'pose',
                            '--plot', 'out.png')
        numbers = self.row(said, 'pose')
        self.assertLess(numbers[0], 0.99)
        self.assertLess(numbers[2], 97.0)  # precision of walls
        self.assertLess(numbers[3], 97.0)  # and their recall
        self.assertEqual((self.folder / 'out.png').read_bytes()[:8], b'\x89PNG\r\n\x1a\n')

    def testTheToleranceIsThatOfWalls(self):
        def shifted(*arguments):
            said = self.compare(self.write('built', building(), (0.1, 0.0)), '--pose', 0, 0, 0,
                                *arguments)
            return self.row(said, 'pose')
        self.assertLess(shifted('--tolerance', 0)[2], 70.0)
        self.assertGreater(shifted('--tolerance', 1)[2], 99.0)

    def testTheStartSaysWhatCanBeReached(self):
        cells = building()
        for y in range(60):
            cells[y][30] = WALL
        truth = self.write('divided', cells)
        result = self.run_(truth, truth, '--pose', 0, 0, 0, '--start', 1.5, 1.5)
        self.assertLess(self.row(result.stdout, 'pose')[4], 50.0)
        self.assertEqual(self.row(self.run_(truth, truth, '--pose', 0, 0, 0).stdout, 'pose')[6],
                         100.0)

    def testTheExitCodeIsForScripts(self):
        self.assertEqual(self.run_(self.truth, self.truth, '--at-least', 0.97).returncode, 0)
        empty = building()
        empty[1:59] = [[WALL] + 78 * [OPEN] + [WALL] for _ in range(58)]
        result = self.run_(self.write('built', empty), self.truth, '--at-least', 0.97)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r'the resemblance is 0\.9\d+, below 0\.97\.')

    def testRefusesWhatCantBeAligned(self):
        blank = self.write('blank', [[UNKNOWN] * 20 for _ in range(20)])
        result = self.run_(blank, self.truth)
        self.assertEqual(result.returncode, 1)
        self.assertIn("A map without walls can't be aligned.", result.stderr)
        result = self.run_(blank, self.truth, '--align', 'sift')
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, 'Too few control points agree|SIFT is not in this OpenCV')

    def testRefusesBadInput(self):
        for arguments, sentence in (
                (('missing.yaml', self.truth), 'missing.yaml'),
                ((self.truth, self.write('cut', building())), 'cut off'),
                ((self.truth, self.truth, '--align', 'pose'), '--align pose needs --pose.'),
                ((self.truth, self.truth, '--tolerance', '-1'), 'wall_tolerance must be'),
                ((self.truth, self.truth, '--plot', '/dev/null/out.png'), 'out.png')):
            path = self.folder / 'cut.pgm'
            if path.exists():
                path.write_bytes(path.read_bytes()[:1000])
            result = self.run_(*arguments)
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertIn(sentence, result.stderr)
            self.assertEqual(len(result.stderr.strip().split('\n')), 1, result.stderr)
        self.assertNotEqual(self.run_(self.truth).returncode, 0)


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
