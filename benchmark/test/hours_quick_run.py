#!/usr/bin/env python3
"""A quick run of the experiments on drives for hours: the tables, the plot and the page."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from tables import readTable  # noqa: E402  (the path comes first)

HOUR = 400  # keyframes


def drive(program, table, *arguments):
    with open(table, 'w', encoding='utf-8') as stream:
        subprocess.run([program, 'hours', '--keyframes', str(2 * HOUR), '--per-hour', str(HOUR),
                        *arguments], check=True, stdout=stream)
    return readTable(table)


def check(thinned, kept):
    for rows in (thinned, kept):
        assert [row['keyframes'] for row in rows] == [HOUR, 2 * HOUR], rows
        for row in rows:
            assert 0.0 < row['median_ms'] <= row['p99_ms'] <= row['max_ms'], row
            assert row['error_m'] < 3.0 * row['stated_m'] < 3.0, row
            assert row['relative_error_m'] < 0.5, row
    assert kept[-1]['estimated'] == 2 * HOUR, kept
    assert thinned[-1]['estimated'] < 0.7 * 2 * HOUR, thinned
    assert thinned[-1]['constraints'] < kept[-1]['constraints'], (thinned, kept)


def checkReport(out):
    page = SOURCE / 'docs/experiments/graph_hours.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_graph_hours.py', '--page',
                    page, '--out', out], check=True)
    text = (out / page.name).read_text(encoding='utf-8')
    assert text.count(f'| 2 | {2 * HOUR} | ') == 2, 'the tables are not those of this run'
    assert (out / 'graph_hours/hours.png').stat().st_size > 5000


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='graph_experiments')
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        tables = pathlib.Path(folder) / 'graph_hours'
        tables.mkdir()
        check(drive(arguments.program, tables / 'thinned.csv', '--keyframes-per-place', '3'),
              drive(arguments.program, tables / 'kept.csv', '--keyframes-per-place', '0'))
        checkReport(pathlib.Path(folder))


if __name__ == '__main__':
    main()
