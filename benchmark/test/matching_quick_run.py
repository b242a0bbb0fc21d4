#!/usr/bin/env python3
"""A quick run of the experiments: its tables have the right shape and say nothing that can't be.

Runs matching_experiments on few scans and levels, twice; then draws the plots and fills the page.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from tables import readTable  # noqa: E402  (the path comes first)

SCANS = 3
LEVELS = 3
SHARES = ('within', 'within_determined', 'trusted', 'trusted_wrong')


def runAll(program, folder):
    """Every experiment in the lab, small."""
    common = ['--map', str(SOURCE / 'maps/lab.yaml'), '--name', 'lab', '--scans', str(SCANS),
              '--out', str(folder)]
    for arguments in (['errors'], ['consistency'], ['reliability'],
                      ['elimination', '--noise', 'translation'],
                      ['elimination', '--noise', 'rotation']):
        if arguments[0] == 'elimination':
            arguments += ['--levels', str(LEVELS)]
        subprocess.run([program, *arguments, *common], check=True, stdout=subprocess.DEVNULL)


def matcherNames(program):
    return subprocess.run([program, 'list'], check=True, stdout=subprocess.PIPE,
                          text=True).stdout.split()


def checkErrors(folder):
    rows = readTable(folder / 'errors_lab.csv')
    for kind, far in (('translation', 1.0), ('rotation', 1.0), ('single', 1.0)):
        errors = {round(row['displacement'], 3): row['squared_error']
                  for row in rows if row['kind'] == kind}
        assert len(errors) > 100, f'{len(errors)} rows of {kind}'
        there = errors[min(errors, key=lambda displacement: abs(displacement - far))]
        assert errors[0.0] < 0.1 * there, f'{kind}: {errors[0.0]} at 0, {there} at {far}'


def checkElimination(folder, noise, names):
    rows = readTable(folder / f'elimination_lab_{noise}.csv')
    assert {row['matcher'] for row in rows} == {*names, 'information'}
    for name in names:
        levels = [row['level'] for row in rows if row['matcher'] == name]
        assert len(levels) == LEVELS and levels == sorted(levels), levels
    for row in rows:
        assert row['matcher'] == 'information' or row['matches'] == SCANS, row
        assert row['determined'] <= row['matches'], row
        assert all(row[key] <= 1.0 for key in row if 'quotient' in key), row
        assert all(0.0 <= row[key] <= 1.0 for key in SHARES), row
        assert row['trusted_wrong'] <= row['trusted'], row
        assert row['matcher'] != 'information' or row['within'] == 1.0, row


def checkPlaces(folder, noise):
    row, = readTable(folder / f'places_lab_{noise}.csv')
    assert row['places'] == SCANS
    assert row['determined'] + row['too_few_returns'] + row['open_direction'] == SCANS, row


def checkConsistency(folder, names):
    rows = readTable(folder / 'consistency_lab.csv')
    assert {row['matcher'] for row in rows} == set(names)
    for row in rows:
        assert row['trusted'] <= row['claiming'] <= row['pairs'] == SCANS, row
        assert 0.0 <= row['inside'] <= 1.0 and row['mean_squared_length'] >= 0.0, row


def checkReliability(folder, names):
    rows = readTable(folder / 'reliability_lab.csv')
    for guess, others in (('near', ['pcl_icp', 'pcl_ndt']), ('far', ['pcl_icp', 'pcl_ndt']),
                          ('anywhere', [])):
        found = {row['matcher'] for row in rows if row['guess'] == guess}
        assert found == {*names, *others}, found
    assert all(0.0 <= row[key] <= 1.0 for row in rows for key in SHARES), rows
    unit, = (row for row in readTable(folder / 'speed_lab.csv')
             if row['guess'] == 'near' and row['matcher'] == 'pcl_icp')
    assert unit['of_pcl_icp'] == 1.0 and unit['microseconds'] > 0.0, unit


def checkSame(first, second):
    names = sorted(path.name for path in first.iterdir())
    assert names == sorted(path.name for path in second.iterdir())
    for name in names:
        if not name.startswith(('seconds_', 'speed_')):
            same = (first / name).read_bytes() == (second / name).read_bytes()
            assert same, f'{name} differs from run to run'


def checkReport(out):
    page = SOURCE / 'docs/experiments/matching.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_matching.py', '--page', page,
                    '--out', out], check=True)
    text = (out / 'matching.md').read_text(encoding='utf-8')
    assert '| lab | 3 |' in text, 'the table of places is not the one of this run'
    for plot in ('errors', 'single', 'quotient_translation', 'within_rotation',
                 'reliability'):
        assert (out / 'matching' / f'{plot}.png').stat().st_size > 5000, plot


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--program', required=True, help='matching_experiments')
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as folder:
        first, second = pathlib.Path(folder, 'first/matching'), pathlib.Path(folder, 'second')
        runAll(program, first)
        runAll(program, second)
        checkSame(first, second)
        checkErrors(first)
        names = matcherNames(program)
        checkConsistency(first, names)
        checkReliability(first, names)
        for noise in ('translation', 'rotation'):
            checkElimination(first, noise, names)
            checkPlaces(first, noise)
        checkReport(first.parent)


if __name__ == '__main__':
    main()
