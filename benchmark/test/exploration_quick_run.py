#!/usr/bin/env python3
"""A quick run of the experiments on exploration: two rooms, explored twice, and the page of it."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from tables import readTable  # noqa: E402  (the path comes first)

WIDTH, HEIGHT = 100, 60  # cells of 5 cm


def drawRooms(folder):
    """A map of two rooms with a door of a metre between them."""
    def isWall(column, row):
        edge = column in (0, WIDTH - 1) or row in (0, HEIGHT - 1)
        return edge or (column == 60 and not 5 <= row < 25)
    pixels = bytes(0 if isWall(column, row) else 254
                   for row in range(HEIGHT) for column in range(WIDTH))
    (folder / 'rooms.pgm').write_bytes(b'P5\n%d %d\n255\n' % (WIDTH, HEIGHT) + pixels)
    description = folder / 'rooms.yaml'
    description.write_text('image: rooms.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\n'
                           'negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n',
                           encoding='utf-8')
    return description


def explore(program, world, out, *options):
    subprocess.run([program, world, '--urdf', SOURCE / 'urdf/turtlebot2.urdf', '--seeds', '2',
                    '--strategies', 'tour=1', '--bound', '--out', out, *options], check=True)
    (row,) = readTable(out / 'runs_rooms.csv')
    return row


def isRefused(program, world, strategies, out):
    return subprocess.run([program, world, '--urdf', SOURCE / 'urdf/turtlebot2.urdf',
                           '--strategies', strategies, '--out', out],
                          stderr=subprocess.DEVNULL, check=False).returncode != 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='exploration_experiments')
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        world = drawRooms(out)
        run = explore(program, world, out / 'exploration')
        assert run['ended'] == 1 and run['ending'] == 'done', run
        assert run['coverage'] >= 0.99 and run['collisions'] == 0, run
        assert run['from_home'] <= 0.5, run
        for strategies in ('fastest', 'tour=', 'tour=few', 'tour=0', 'tour=1.5'):
            assert isRefused(program, world, strategies, out / 'refused'), strategies
        again = explore(program, world, out / 'again')
        assert [again[key] for key in ('time', 'distance')] == [run['time'], run['distance']]
        true_run = explore(program, world, out / 'truth', '--localisation', 'truth')
        assert true_run['ending'] == 'done' and true_run['coverage'] >= 0.99, true_run
        assert true_run['from_home'] <= 0.5 and true_run['time'] != run['time'], true_run
        page = SOURCE / 'docs/experiments/exploration.md'
        subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_exploration.py', '--page',
                        page, '--out', out], check=True)
        assert '| rooms | tour | 1 |' in (out / page.name).read_text(encoding='utf-8')
        (bound,) = readTable(out / 'exploration/bound_rooms.csv')
        assert 0.0 <= bound['length'] < run['distance'], (bound, run)
        assert (out / 'exploration/paths_rooms.png').stat().st_size > 5000


if __name__ == '__main__':
    main()
