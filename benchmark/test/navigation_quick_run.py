#!/usr/bin/env python3
"""A quick run of the experiments on navigation: the tables, the plot and the page that they make."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'benchmark/plots'))

from navigation_page import touches  # noqa: E402  (the path comes first)
from tables import readTable  # noqa: E402


def run(program, table, *arguments):
    with open(table, 'w', encoding='utf-8') as stream:
        subprocess.run([program, '--map', SOURCE / 'maps/maze.yaml', '--urdf',
                        SOURCE / 'urdf/turtlebot2.urdf', *arguments], check=True, stdout=stream)
    return readTable(table)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', required=True, help='navigation_experiments')
    program = parser.parse_args().program
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        tables = out / 'navigation'
        tables.mkdir()
        queries = run(program, tables / 'queries.csv', 'queries', '--count', '20')
        assert len(queries) == 20, queries
        assert all(row['found'] == row['has_way'] for row in queries), queries
        assert not any(map(touches, queries)), queries
        again = run(program, tables / 'again.csv', 'queries', '--count', '20')
        assert [row['length'] for row in again] == [row['length'] for row in queries]
        goals = run(program, tables / 'goals.csv', 'goals', '--count', '1', '--people', '1')
        assert len(goals) == 1 and goals[0]['collisions'] == 0, goals
        page = SOURCE / 'docs/experiments/navigation.md'
        subprocess.run([sys.executable, SOURCE / 'benchmark/plots/report_navigation.py', '--page',
                        page, '--out', out], check=True)
        text = (out / page.name).read_text(encoding='utf-8')
        assert '| maze | 20 | 20 | 100.00 % |' in text, text
        assert (tables / 'plans.png').stat().st_size > 5000


if __name__ == '__main__':
    main()
