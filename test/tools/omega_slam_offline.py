#!/usr/bin/env python3
"""omega_slam_offline from the outside: a made-up log, what is written of it, and what is refused."""
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ''
BEAMS = 181
HALF_WIDTH, HALF_LENGTH = 2.0, 4.0  # [m] of the room
RESULTS = ('map.pgm', 'map.yaml', 'map.png', 'trajectory.tum', 'graph.g2o', 'report.json', 'report.md')
SLIP = 1.03  # the wheels say so much more than is driven


def rangeAt(x, y, angle):
    """[m] from a place in the room to its walls, which stand around the origin."""
    c, s = math.cos(angle), math.sin(angle)
    along = (math.copysign(HALF_LENGTH, c) - x) / c if abs(c) > 1e-9 else math.inf
    across = (math.copysign(HALF_WIDTH, s) - y) / s if abs(s) > 1e-9 else math.inf
    return min(along, across)


def poseAt(turn):
    """On a circle of a metre in the middle, counterclockwise."""
    return math.cos(turn), math.sin(turn), turn + math.pi / 2


def flaser(k, step=0.05):
    x, y, theta = poseAt(step * k)
    ranges = (rangeAt(x, y, theta + math.radians(beam - 90)) for beam in range(BEAMS))
    wheels = '{:.4f} {:.4f} {:.4f}'.format(SLIP * x, SLIP * y, theta)
    words = (f'FLASER {BEAMS}', *(f'{r:.3f}' for r in ranges), wheels, wheels, f'{0.2 * k:.2f} host 0')
    return ' '.join(words)


def roomLog(scans=160):
    return '\n'.join(flaser(k) for k in range(scans)) + '\n'


class OfflineTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              env=dict(os.environ, **environment), capture_output=True, timeout=120,
                              check=False)

    def refusal(self, *arguments):
        result = self.run_(*arguments)
        self.assertNotEqual(result.returncode, 0)
        self.assertNotIn('terminate', result.stderr)
        return result.stderr

    def testMapsARoom(self):
        result = self.run_(self.write('room.clf', roomLog()))
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads((self.folder / 'results/report.json').read_text())
        self.assertEqual(report['scans']['used'], 160)
        rows = [line.split() for line in
                (self.folder / 'results/trajectory.tum').read_text().splitlines() if line[0] != '#']
        self.assertEqual(len(rows), 160)
        # Half a turn is the circle's diameter, whatever the wheels say.
        half = round(math.pi / 0.05)
        driven = math.dist(*[[float(rows[k][1]), float(rows[k][2])] for k in (0, half)])
        self.assertAlmostEqual(driven, 2.0, delta=0.02)

    def testSaysWhatIsAlwaysWrongWithTheOdometry(self):
        result = self.run_(self.write('room.clf', roomLog(320)))
        self.assertEqual(result.returncode, 0, result.stderr)
        report = json.loads((self.folder / 'results/report.json').read_text())
        said = [note for note in report['notes'] if note.startswith('The odometry is wrong throughout')]
        self.assertEqual(len(said), 1, report['notes'])
        share = re.search(r'ways are (\d\.\d) % shorter', said[0])
        self.assertIsNotNone(share, said[0])
        self.assertAlmostEqual(float(share[1]), 100.0 * (1.0 - 1.0 / SLIP), delta=1.0)

    def testSameLogSameBytes(self):
        """However many threads the libraries may have, and wherever the user lives."""
        log = self.write('room.clf', roomLog())
        runs = ({'OMP_NUM_THREADS': '1'}, {'OMP_NUM_THREADS': '4'}, {'LC_ALL': 'de_DE.UTF-8'})
        for number, environment in enumerate(runs):
            self.run_(log, '--out', f'run{number}', **environment)
        for name in RESULTS:
            first, *others = [(self.folder / f'run{number}' / name).read_bytes()
                              for number in range(len(runs))]
            self.assertGreater(len(first), 0, name)
            for other in others:
                self.assertEqual(first, other, name)

    def testScoresWithRelations(self):
        half = 0.2 * round(math.pi / 0.05)
        self.write('room.relations', f'0 {half} 0 2 0 0 0 {math.pi}\n0 9999 1 0 0 0 0 0\n')
        result = self.run_(self.write('room.clf', roomLog()), '--relations', 'room.relations')
        self.assertRegex(result.stdout, r'Relations: 1 of 2 covered, 0\.0\d+ ')

    def testInterruptedItSavesWhatItHas(self):
        log = self.write('room.clf', roomLog(6000))
        process = subprocess.Popen([PROGRAM, str(log), '--out', 'out'], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stderr.readline()  # what the log holds: the work begins
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        used = json.loads((self.folder / 'out/report.json').read_text())['scans']['used']
        self.assertTrue(0 < used < 6000, used)

    def testGarbledLinesCostOnlyThemselves(self):
        lines = roomLog().splitlines()
        lines[20] = lines[20][:200]
        lines[30] = lines[30].replace('host', 'nan nan', 1)
        lines[40] = 'FLASER 3 1 2 3 nan 0 0 nan 0 0 8.0 host 0'
        lines[50] = '\0\1\2'
        result = self.run_(self.write('room.clf', '\n'.join(lines) + '\n'))
        self.assertEqual(result.returncode, 0, result.stderr)
        used = json.loads((self.folder / 'results/report.json').read_text())['scans']['used']
        self.assertGreaterEqual(used, 156)

    def testSaysWhatIsWrong(self):
        log = self.write('room.clf', roomLog(5))
        self.assertIn('absent.clf: there is no such file', self.refusal('absent.clf'))
        self.write('empty.clf', '')
        self.assertIn('empty.clf', self.refusal('empty.clf'))
        self.write('bad.yaml', 'scan_matcher:\n  keyframe_translation: -1\n')
        self.assertIn('keyframe_translation', self.refusal(log, '--config', 'bad.yaml'))
        self.write('file', '')
        self.assertIn('file', self.refusal(log, '--out', 'file/results'))

    def testARelationsFileThatCannotBeReadCostsNoWork(self):
        log = self.write('room.clf', roomLog(5))
        self.assertIn('absent.relations', self.refusal(log, '--relations', 'absent.relations'))
        self.assertFalse((self.folder / 'results').exists(), 'it was found out too late')


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
