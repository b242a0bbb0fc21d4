#!/usr/bin/env python3
"""Draws the plots of the scan matching experiments, and writes their tables into the page.

Reads <out>/matching/*.csv; writes <out>/matching/*.png and <out>/matching.md.
"""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import figures  # noqa: E402  (the path comes first)
from page import fillPage, sectionsOf  # noqa: E402
from tables import Results  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--page', type=pathlib.Path, required=True,
                        help='the page, with the text between the tables')
    parser.add_argument('--out', type=pathlib.Path, required=True, help='folder of the results')
    arguments = parser.parse_args()
    results = Results(arguments.out / 'matching')
    figures.drawAll(results, results.folder)
    filled = fillPage(arguments.page.read_text(encoding='utf-8'), sectionsOf(results))
    (arguments.out / 'matching.md').write_text(filled, encoding='utf-8')


if __name__ == '__main__':
    main()
