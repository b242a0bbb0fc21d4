#!/usr/bin/env python3
"""A quick run of the experiments on maps: the tables, pictures and the page that they make."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from map_tables import ALIGNMENTS, SOURCES, having  # noqa: E402  (the path comes first)
from tables import readTable  # noqa: E402

YAML = ('image: den.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n'
        'occupied_thresh: 0.65\nfree_thresh: 0.196\n')
WIDTH, HEIGHT = 90, 70  # cells
WALL, OPEN = 0, 254


def writeDen(folder):
    """A room of 4.5 m by 3.5 m with a few things in it."""
    cells = [[WALL if y < 2 or y >= HEIGHT - 2 or x < 2 or x >= WIDTH - 2 else OPEN
              for x in range(WIDTH)] for y in range(HEIGHT)]
    for left, top, width, height in ((60, 2, 20, 8), (2, 50, 12, 18), (70, 60, 8, 8),
                                     (40, 60, 5, 3)):
        for y in range(top, top + height):
            for x in range(left, left + width):
                cells[y][x] = WALL
    (folder / 'den.pgm').write_bytes(b'P5\n%d %d\n255\n' % (WIDTH, HEIGHT) +
                                     bytes(value for row in cells for value in row))
    (folder / 'den.yaml').write_text(YAML, encoding='utf-8')
    return folder / 'den.yaml'


def checkScores(rows):
    assert len(rows) == 3 * len(SOURCES) * len(ALIGNMENTS), len(rows)
    for row in having(rows, alignment='trajectory'):
        assert row['aligned'] == 1.0 and 0.9 < row['score'] <= 1.0, row
        assert row['coverage'] > 0.9, row
    ideal = having(rows, alignment='trajectory', source='no_noise', renderer='beam')[0]
    assert ideal['wall_precision'] > 0.999, ideal


def checkReport(out):
    page = SOURCE / 'docs/experiments/maps.md'
    subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_maps.py', '--page', page,
                    '--out', out], check=True)
    text = (out / page.name).read_text(encoding='utf-8')
    assert '| den | beam | true poses, no noise |' in text, 'the ceiling is not that of this run'
    assert '| den | triangle |' in text, 'scores are not those of this run'
    assert (out / 'maps/scores.png').stat().st_size > 5000


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='map_experiments')
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        tables = out / 'maps'
        subprocess.run([program, 'survey', '--map', writeDen(out), '--name', 'den', '--near', '1',
                        '1', '--out', tables, '--pictures'], check=True)
        for name in ('surveys', 'scores'):
            (tables / f'{name}_den_1.csv').rename(tables / f'{name}.csv')
        survey, = readTable(tables / 'surveys.csv')
        assert survey['keyframes'] > 2 and survey['mean_error'] < 0.1, survey
        checkScores(readTable(tables / 'scores.csv'))
        for picture in ('den_truth', 'den_beam', 'den_triangle_differences'):
            assert (tables / f'{picture}.png').stat().st_size > 3000, picture
        checkReport(out)


if __name__ == '__main__':
    main()
