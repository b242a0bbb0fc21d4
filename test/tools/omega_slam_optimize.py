#!/usr/bin/env python3
"""omega_slam_optimize from the outside: what it writes, what it says, and how it refuses."""
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ''
EDGE = 'EDGE_SE2 {} {} {} {} {} 10 0 0 10 0 100\n'
QUARTER = math.pi / 2


def square(gap=0.0):
    """Ids 10, 20 ... 50: four sides of a metre, the last node back at the first."""
    text = ''.join(f'VERTEX_SE2 {10 * k} 0 0 0\n' for k in range(1, 6))
    text += ''.join(EDGE.format(10 * k, 10 * k + 10, 1.0 + (gap if k == 4 else 0.0), 0, QUARTER)
                    for k in range(1, 5))
    return text + EDGE.format(10, 50, 0, 0, 2 * math.pi)


class OptimizeTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              capture_output=True, timeout=60, check=False)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def solve(self, text, *arguments):
        result = self.run_(self.write('in.g2o', text), *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def testSolvesAndKeepsIds(self):
        said = self.solve(square(gap=0.2), 'out.g2o')
        self.assertRegex(said, r'first guess \((odometry|tree|chordal)\)')
        self.assertRegex(said, r'Converged after \d+ iterations')
        lines = (self.folder / 'out.g2o').read_text().split('\n')
        self.assertTrue(lines[0].startswith('VERTEX_SE2 10 0 0 0'))
        third = [float(field) for field in lines[2].split()[2:]]
        self.assertAlmostEqual(third[0], 1.0, delta=0.1)
        self.assertAlmostEqual(third[1], 1.0, delta=0.1)

    def testAGraphThatFitsHasNoError(self):
        self.assertRegex(self.solve(square()), r'chi-square 0\.000000\n$')

    def testWritesTheOtherFormats(self):
        self.solve(square(), 'out.toro', '--plot', 'out.png', '--residuals', 'out.csv')
        self.assertTrue((self.folder / 'out.toro').read_text().startswith('VERTEX2 10 '))
        self.assertEqual((self.folder / 'out.png').read_bytes()[:8], b'\x89PNG\r\n\x1a\n')
        table = (self.folder / 'out.csv').read_text().split('\n')
        self.assertEqual(table[0], 'from,to,kind,chi_square,weight')
        self.assertEqual(len(table), 1 + 5 + 1)
        self.solve(square(), 'out.tum')
        path = [line.split() for line in (self.folder / 'out.tum').read_text().split('\n')[:-1]]
        self.assertEqual([fields[0] for fields in path], ['10', '20', '30', '40', '50'])
        self.assertAlmostEqual(float(path[1][6]), math.sin(QUARTER / 2), places=6)

    def testThePapersEquationsAndAKernelAreThere(self):
        lie = square() + EDGE.format(10, 30, -5, -5, 0)
        plain = self.solve(lie)
        doubted = self.solve(lie, '--kernel', 'graduated', '--width', '3')
        self.assertNotIn('below one half', plain)
        self.assertIn('1 constraints have a weight below one half', doubted)
        self.assertIn('Converged after 1 iterations', self.solve(square(), '--method', 'linear',
                                                                 '--guess', 'odometry'))

    def testNamesFalseLoops(self):
        drive = ''.join(EDGE.format(k, k + 1, 1.0, 0, QUARTER) for k in range(40))
        drive += ''.join(EDGE.format(k, k + 4, 0, 0, 2 * math.pi) for k in range(37))
        said = self.solve(drive + EDGE.format(3, 30, 5, 5, 0), '--loops', 'doubt',
                          '--residuals', 'out.csv')
        self.assertEqual([line for line in said.split('\n') if line.startswith('loop ')],
                         [line for line in said.split('\n')
                          if line.startswith('loop 3 - 30 is contradicted: ')])
        self.assertIn('1 constraints have a weight below one half', said)
        rows = (self.folder / 'out.csv').read_text().split('\n')[1:-1]
        doubted = [row for row in rows if row.endswith(',0')]
        self.assertEqual(len(doubted), 1)
        self.assertTrue(doubted[0].startswith('3,30,loop,'))

    def testThinsOut(self):
        rounds = ''.join(EDGE.format(k, k + 1, 1.0, 0, QUARTER) for k in range(100))
        rounds += ''.join(EDGE.format(k, k + 4, 0, 0, 2 * math.pi) for k in range(97))
        said = self.solve(rounds, 'out.g2o', '--thin', '0.5')
        self.assertRegex(said, r'Thinned out: \d+ of 101 nodes are left')
        left = (self.folder / 'out.g2o').read_text().count('VERTEX_SE2')
        self.assertLess(left, 90)

    def expectRefusal(self, result, *words):
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual(len(result.stderr.strip().split('\n')), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def testRefusesWithOneSentence(self):
        self.expectRefusal(self.run_('absent.g2o'), 'absent.g2o', 'no such file')
        self.expectRefusal(self.run_(self.write('bad.g2o', 'VERTEX_SE2 0 0 x 0\n')),
                           'bad.g2o:1', 'not a finite number')
        self.expectRefusal(
            self.run_(self.write('good.g2o', square()), 'good.g2o/out.g2o'), 'good.g2o/out.g2o')
        loose = EDGE.format(0, 1, 1, 0, 0) + 'EDGE_SE2 1 2 1 0 0 0 0 0 0 0 0\n'
        self.expectRefusal(self.run_(self.write('loose.g2o', loose)), 'singular')

    def testRefusesUnknownWords(self):
        good = self.write('good.g2o', square())
        for option in ('--kernel', '--method', '--guess'):
            result = self.run_(good, option, 'nonsense')
            self.assertNotEqual(result.returncode, 0)
            self.assertIn('nonsense', result.stderr + result.stdout)


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
