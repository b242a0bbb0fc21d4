#!/usr/bin/env python3
"""A quick run of the experiments on the graph's solver: its tables say nothing that can't be.

Runs graph_experiments on two small towns, twice; then draws the plots and fills the page.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from tables import readTable  # noqa: E402  (the path comes first)

SIZES = (200, 400)
GUESSES = ('best', 'odometry', 'tree', 'chordal')
TIMES = ('milliseconds', 'guess_milliseconds', 'peak_mb')


class Program:
    def __init__(self, path, folder):
        self.path = path
        self.folder = folder

    def run(self, *arguments):
        return subprocess.run([self.path, *map(str, arguments)], check=True,
                              stdout=subprocess.PIPE, text=True).stdout

    def tabulate(self, table, *arguments):
        """Adds the row that is printed to a table."""
        head, row = self.run(*arguments).splitlines()
        path = self.folder / f'{table}.csv'
        with open(path, 'a', encoding='utf-8') as stream:
            stream.write(f'{row}\n' if stream.tell() else f'{head}\n{row}\n')


def solveAll(program, solvers):
    for size in SIZES:
        town = program.folder / f'town_{size}.g2o'
        program.run('grid', '--poses', size, '--out', town)
        for guess in GUESSES:
            for solver in solvers:
                program.tabulate('solves', 'solve', town, '--solver', solver, '--guess', guess,
                                 '--repetitions', 1)
        program.tabulate('online', 'online', town, '--times',
                         program.folder / f'online_ours_{town.stem}.csv')
        program.tabulate('scaling', 'solve', town, '--solver', 'ours', '--repetitions', 3)


def checkSolves(folder, solvers):
    rows = readTable(folder / 'solves.csv')
    assert len(rows) == len(SIZES) * len(GUESSES) * len(solvers), len(rows)
    for size in SIZES:
        of_town = [row for row in rows if row['graph'] == f'town_{size}']
        least = min(row['chi_square'] for row in of_town)
        degrees = 3 * (of_town[0]['constraints'] - size + 1)
        assert of_town[0]['poses'] == size and abs(least / degrees - 1.0) < 0.3, (least, degrees)
        for row in of_town:
            assert row['chi_square'] <= row['initial_chi_square'], row
            assert row['chi_square'] < 1.001 * least or row['guess'] == 'odometry', row
            assert row['milliseconds'] > 0.0 and row['peak_mb'] > 1.0, row
            assert row['iterations'] >= 1, row


def checkOnline(folder):
    """A graph that came pose by pose ends where the whole one does."""
    solves = readTable(folder / 'solves.csv')
    for row in readTable(folder / 'online.csv'):
        least = min(other['chi_square'] for other in solves if other['graph'] == row['graph'])
        assert row['chi_square'] < 1.001 * least, row
        updates = readTable(folder / f'online_ours_{row["graph"]}.csv')
        assert [update['pose'] for update in updates] == list(range(int(row['poses']))), row
        assert sum(update['microseconds'] for update in updates) > 0.0, row


def checkSame(first, second):
    """All but what depends on the machine's mood."""
    for name in ('solves', 'scaling', 'online'):
        tables = [[{key: value for key, value in row.items() if key not in TIMES}
                   for row in readTable(folder / f'{name}.csv')] for folder in (first, second)]
        assert tables[0] == tables[1], f'{name} differs from run to run'


def checkScore(program):
    """A solution is scored by the graph; none at all has failed."""
    town = program.folder / f'town_{SIZES[0]}.g2o'
    guessed = program.folder / 'guessed.g2o'
    program.run('guess', town, '--guess', 'tree', '--out', guessed)
    for name, solved in (('scored', [guessed]), ('failed', [])):
        program.tabulate(name, 'score', town, *solved, '--solver', 'g2o_gn', '--guess', 'odometry',
                         '--iterations', 7)
    tree, = (row for row in readTable(program.folder / 'solves.csv')
             if (row['graph'], row['guess'], row['solver']) == (town.stem, 'tree', 'ours'))
    scored, = readTable(program.folder / 'scored.csv')
    assert scored['chi_square'] == tree['initial_chi_square'] and scored['iterations'] == 7, scored
    failed, = readTable(program.folder / 'failed.csv')
    assert math.isinf(failed['chi_square']), failed


def checkReport(out):
    page = SOURCE / 'docs/experiments/graph.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_graph.py', '--page', page,
                    '--out', out], check=True)
    text = (out / 'graph.md').read_text(encoding='utf-8')
    assert f'| town_{SIZES[0]} | {SIZES[0]} |' in text, 'the contest is not the one of this run'
    assert 'without GTSAM and g2o' in text, 'the page does not say that peers are missing'
    for plot in ('contest', 'scaling', 'online'):
        assert (out / 'graph' / f'{plot}.png').stat().st_size > 5000, plot


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--program', required=True, help='graph_experiments')
    parser.add_argument('--solvers', nargs='+', required=True, help='that it has')
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        first, second = pathlib.Path(folder, 'first/graph'), pathlib.Path(folder, 'second')
        for tables in (first, second):
            tables.mkdir(parents=True)
            solveAll(Program(arguments.program, tables), arguments.solvers)
        checkSame(first, second)
        checkSolves(first, arguments.solvers)
        checkOnline(first)
        checkScore(Program(arguments.program, second))
        checkReport(first.parent)


if __name__ == '__main__':
    main()
