#!/usr/bin/env python3
"""What the plots and the page of the experiments are made of."""
import math
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'plots'))

from graph_page import contestSection, exponent, number, peersSection  # noqa: E402  (path first)
from graph_tables import Contest, GraphResults, leastOfRounds  # noqa: E402
from matching_figures import localMinima  # noqa: E402
from matching_page import nearest, stretchAbove  # noqa: E402
from matching_tables import MatchingResults, byMatcher, inOrder  # noqa: E402
from page import fillPage, percent  # noqa: E402


def rowsOf(*quotients):
    return [{'level': 0.1 * k, 'q': q} for k, q in enumerate(quotients, start=1)]


class Valleys(unittest.TestCase):
    def testOneThatIsDeepEnough(self):
        self.assertEqual(localMinima([3, 2, 1, 2, 3], 0.5), [2])

    def testShallowOnesAreNoise(self):
        self.assertEqual(localMinima([1, 0.9, 1, 0.9, 1, 0, 1], 0.5), [5])
        self.assertEqual(len(localMinima([1, 0.9, 1, 0.9, 1, 0, 1], 0.05)), 3)

    def testSlopesAndPlainsHaveNone(self):
        for values in ([1, 2, 3], [3, 2, 1], [2, 2, 2]):
            self.assertEqual(localMinima(values, 0.5), [])


class Page(unittest.TestCase):
    PAGE = 'Words.\n<!-- begin a -->\nold\n<!-- end a -->\n<!-- begin b -->\nkept\n<!-- end b -->\n'

    def testTakesTables(self):
        filled = fillPage(self.PAGE, {'a': '| new |\n'})
        self.assertEqual(filled, self.PAGE.replace('old', '| new |'))

    def testTakesThemAgain(self):
        filled = fillPage(self.PAGE, {'a': 'x\n', 'b': 'y\n'})
        self.assertEqual(fillPage(filled, {'a': 'old\n', 'b': 'kept\n'}), self.PAGE)

    def testStretchIsTheLongest(self):
        rows = rowsOf(0.96, 0.5, 0.95, 0.97, 0.99, 0.2)
        self.assertEqual(stretchAbove(rows, 'q', 0.95), '0.30 to 0.50')
        self.assertEqual(stretchAbove(rows[2:4], 'q', 0.95), '0.30 to 0.40')
        self.assertEqual(stretchAbove(rows, 'q', 0.999), 'nowhere')

    def testNearestLevel(self):
        self.assertEqual(nearest(rowsOf(1, 2, 3), 0.22)['q'], 2)

    def testPercent(self):
        self.assertEqual(percent(0.98765), '98.8 %')


class Tables(unittest.TestCase):
    def testAreFoundByTheirNames(self):
        with tempfile.TemporaryDirectory() as folder:
            results = MatchingResults(pathlib.Path(folder))
            for name in ('errors_swarmlab', 'errors_lab', 'places_lab_rotation'):
                (results.folder / f'{name}.csv').write_text('a,b\n1.5,x\n')
            self.assertEqual(results.worlds('errors'), ['lab', 'swarmlab'])
            self.assertEqual(results.worlds('places'), ['lab'])
            self.assertEqual(results.table('errors', 'lab'), [{'a': 1.5, 'b': 'x'}])
            self.assertTrue(results.has('places', 'lab', 'rotation'))
            self.assertFalse(results.has('places', 'lab'))

    def testMatchersComeInTheOrderOfThePaper(self):
        self.assertEqual(inOrder(['new', 'icp', 'hill_climbing']), ['hill_climbing', 'icp', 'new'])
        rows = [{'matcher': 'icp', 'x': 1}, {'matcher': 'particles'}, {'matcher': 'icp', 'x': 2}]
        self.assertEqual(list(byMatcher(rows)), ['particles', 'icp'])
        self.assertEqual([row['x'] for row in byMatcher(rows)['icp']], [1, 2])


def solve(solver, guess, milliseconds, chi_square=100.0, graph='intel'):
    return {'graph': graph, 'guess': guess, 'solver': solver, 'poses': 50.0,
            'chi_square': chi_square, 'milliseconds': milliseconds, 'guess_milliseconds': 1.0}


class Solves(unittest.TestCase):
    def testTheLeastOfAllRoundsCounts(self):
        rows = [solve('ceres', 'tree', 5), solve('ours', 'tree', 3), solve('ours', 'tree', 2)]
        self.assertEqual([(row['solver'], row['milliseconds']) for row in leastOfRounds(rows)],
                         [('ours', 2), ('ceres', 5)])

    def testWhoStopsTooEarlyDoesNotWin(self):
        rows = [solve('ours', 'best', 4), solve('ceres', 'tree', 1, 100.2),
                solve('ceres', 'chordal', 6, 100.05), solve('g2o_gn', 'tree', 2, math.inf)]
        contest = Contest(rows, 'intel')
        self.assertEqual(contest.fastest({'ceres'})['guess'], 'chordal')
        self.assertIsNone(contest.fastest({'g2o_gn'}))
        self.assertEqual(contest.ours()['milliseconds'], 4)

    def contest(self, *rows):
        """The sections on who is first, and on whose packages were there."""
        with tempfile.TemporaryDirectory() as folder:
            results = GraphResults(pathlib.Path(folder))
            lines = [','.join(rows[0]), *(','.join(map(str, row.values())) for row in rows)]
            (results.folder / 'solves.csv').write_text('\n'.join(lines))
            return contestSection(results), peersSection(results)

    def testRatiosAreToTheFastestPeer(self):
        table, peers = self.contest(solve('ours', 'best', 4), solve('ours', 'tree', 9),
                                    solve('ceres', 'tree', 7), solve('g2o_gn', 'tree', 5))
        self.assertIn('| g2o Gauss-Newton, tree | 5.00 | 0.80 | 0.83 |', table)
        self.assertIn('without GTSAM', peers)

    def testTheTimeOfAGuessCountsOnBothSides(self):
        dear = {**solve('ours', 'chordal', 9), 'guess_milliseconds': 6.0}
        table, _ = self.contest(solve('ours', 'best', 4), solve('ours', 'tree', 9), dear,
                                solve('g2o_gn', 'tree', 7), solve('g2o_gn', 'chordal', 5))
        self.assertIn('| g2o Gauss-Newton, chordal | 5.00 | 0.80 | 0.62 |', table)

    def testThereIsNoRatioForTheWrongMinimum(self):
        table, _ = self.contest(solve('ours', 'best', 4, 101.0), solve('g2o_gn', 'tree', 5))
        self.assertIn('| 5.00 | not reached | - |', table)

    def testExponentIsThatOfAPower(self):
        rows = [{'poses': n, 'time': 3.0 * n ** 1.5} for n in (10000.0, 20000.0, 50000.0)]
        self.assertAlmostEqual(exponent(rows, 'time'), 1.5)
        self.assertAlmostEqual(exponent([{'poses': 10.0, 'time': 1.0}, *rows], 'time'), 1.5)
        self.assertIsNone(exponent(rows[:1], 'time'))

    def testFailuresAreWords(self):
        self.assertEqual(number(math.inf), 'failed')
        self.assertEqual(number(45.00469581, 6), '45.0047')


if __name__ == '__main__':
    unittest.main()
