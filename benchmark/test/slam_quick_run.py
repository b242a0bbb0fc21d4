#!/usr/bin/env python3
"""A quick run of the experiments on SLAM: the tables, the plot and the page that they make."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from slam_page import FAULTS  # noqa: E402  (the path comes first)
from slam_tables import having  # noqa: E402
from tables import readTable  # noqa: E402

LAB = SOURCE / 'maps/lab.world.yaml'
FEW = ('none', 'missing_30', 'odometry_reset')
SECONDS = '12'


def run(program, table, *arguments):
    rows = subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                          text=True).stdout
    table.write_text(rows, encoding='utf-8')
    return readTable(table)


def writeLog(path):
    """A robot that stands, while its wheels slip."""
    lines = []
    for k in range(60):
        ranges = ' '.join(['3.00'] * 45 + ['50.0'] * 90 + [f'{2.0 + 0.01 * (k % 2):.2f}'] * 46)
        pose = f'{0.01 * k:.3f} 0.0 0.0'
        lines.append(f'FLASER 181 {ranges} {pose} {pose} {1000.0 + 0.2 * k:.1f} host 0.0')
    path.write_text('\n'.join(lines) + '\n', encoding='utf-8')


def checkLog(program, folder):
    writeLog(folder / 'made.clf')
    (folder / 'made.relations').write_text('1000 1004 0 0 0 0 0 0\n1000 2000 1 0 0 0 0 0\n')
    row, = run(program, folder / 'slam/accuracy.csv', 'log', folder / 'made.clf', '--name',
               'intel_first', '--relations', folder / 'made.relations')
    assert row['scans'] == 60 and row['covered'] == 1.0, row
    assert row['error'] < 0.1 < row['odometry_error'] < 0.3, row
    assert row['cpu_seconds'] > 0.0, row


def checkCost(program, folder):
    log = (folder / 'made.clf', '--name', 'csail')
    walls, = run(program, folder / 'slam/walls.csv', 'walls', *log, '--out', folder / 'slam')
    assert walls['scans'] == 60 and 0.0 < walls['wall_distance'] < 0.1, walls
    assert (folder / 'slam/csail_omega_slam.png').stat().st_size > 1000
    ratio, = run(program, folder / 'slam/ratio.csv', 'ratio', *log)
    assert ratio['icp_matches'] >= 1 and ratio['ratio'] > 0.0, ratio
    rows = run(program, folder / 'slam/growth.csv', 'growth', *log, '--passes', 20)
    assert [row['scans'] for row in rows] == [500.0, 1000.0], rows
    assert rows[0]['keyframes'] <= rows[1]['keyframes'], rows


def checkSimulation(program, folder):
    drive = ('simulation', '--world', LAB, '--seconds', SECONDS, '--noise', '1,4')
    rows = run(program, folder / 'slam/simulation.csv', *drive)
    assert [row['noise'] for row in rows] == [1.0, 4.0], rows
    assert all(row['covered'] == 1.0 and row['error'] < 0.1 for row in rows), rows
    assert rows[1]['odometry_error'] > rows[0]['odometry_error'], rows
    again = run(program, folder / 'again.csv', *drive)
    for first, second in zip(rows, again):
        same = {key for key in first if str(first[key]) == str(second[key])}
        assert set(first) - same <= {'cpu_seconds', 'median_ms', 'p99_ms', 'max_ms'}, (first, second)


def checkHostile(program, folder):
    rows = run(program, folder / 'slam/hostile.csv', 'hostile', '--world', LAB, '--seconds', SECONDS,
               '--faults', ','.join(FEW))
    assert tuple(row['fault'] for row in rows) == FEW, rows
    whole, = having(rows, fault='none')
    few, = having(rows, fault='missing_30')
    assert 0.5 * whole['scans'] < few['scans'] < 0.9 * whole['scans'], rows


def checkReport(folder):
    page = SOURCE / 'docs/experiments/slam.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_slam.py', '--page', page,
                    '--out', folder], check=True)
    text = (folder / 'slam.md').read_text(encoding='utf-8')
    assert '| Intel, first 1088 s | 60 |' in text, 'the log is not the one of this run'
    assert '| lab | urg | 4 |' in text, 'the drives are not those of this run'
    assert f'| lab, simulated | {FAULTS["odometry_reset"]} |' in text, 'nor are the faults'
    for plot in ('simulation', 'growth'):
        assert (folder / 'slam' / f'{plot}.png').stat().st_size > 5000, plot


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='slam_experiments')
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / 'slam').mkdir()
        checkLog(program, folder)
        checkCost(program, folder)
        checkSimulation(program, folder)
        checkHostile(program, folder)
        checkReport(folder)


if __name__ == '__main__':
    main()
