#!/usr/bin/env python3
"""A quick run of the experiments on false loops: the table, the plot and the page that it makes."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from outlier_tables import SOLVERS, Trials, having, isSpoilt  # noqa: E402  (the path comes first)
from tables import readTable  # noqa: E402

COUNTS = (5, 20)
GROUPS = (1, 5)
SEEDS = 2


def sweep(program, town, table):
    """All solvers; one table with a head."""
    for solver in SOLVERS:
        rows = subprocess.run(
            [program, town, '--solver', solver, '--seeds', str(SEEDS), '--counts',
             *map(str, COUNTS), '--groups', *map(str, GROUPS)],
            check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines(keepends=True)
        with open(table, 'a', encoding='utf-8') as stream:
            stream.writelines(rows[1:] if stream.tell() else rows)


def check(rows):
    assert len(rows) == len(SOLVERS) * (1 + len(COUNTS) * len(GROUPS) * SEEDS), len(rows)
    for solver in SOLVERS:
        clean, = having(rows, solver=solver, false_loops=0)
        assert clean['true_dropped'] == 0 or solver not in ('doubt', 'plain'), clean
        assert clean['error'] < 0.1 * clean['shown_noise'], clean
    doubting = Trials(list(filter(isSpoilt, having(rows, solver='doubt'))))
    believing = Trials(list(filter(isSpoilt, having(rows, solver='plain'))))
    assert doubting.precision() == doubting.recall() == 1.0, doubting.rows
    assert doubting.within() == len(doubting.rows), doubting.rows
    assert believing.recall() == 0.0 and believing.within() == 0, believing.rows


def checkReport(out):
    page = SOURCE / 'docs/experiments/graph_outliers.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_graph_outliers.py', '--page',
                    page, '--out', out], check=True)
    text = (out / page.name).read_text(encoding='utf-8')
    assert '| town | 5 | alone | 0 of 10 |' in text, 'false loops are not those of this run'
    assert '| town | least squares | 0 of 8 |' in text, 'solvers are not those of this run'
    assert '| town | 300 |' in text, 'the clean graph is not the one of this run'
    assert (out / 'graph_outliers/errors.png').stat().st_size > 5000


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='outlier_experiments')
    parser.add_argument('--worlds', required=True, help='graph_experiments')
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        tables = out / 'graph_outliers'
        tables.mkdir()
        subprocess.run([arguments.worlds, 'grid', '--poses', '300', '--out', out / 'town.g2o'],
                       check=True)
        sweep(arguments.program, out / 'town.g2o', tables / 'outliers.csv')
        check(readTable(tables / 'outliers.csv'))
        checkReport(out)


if __name__ == '__main__':
    main()
