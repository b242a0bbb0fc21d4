#!/usr/bin/env python3
"""Draws the plot of the experiments on maps, and writes their tables into the page."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from map_figures import drawAll  # noqa: E402  (the path comes first)
from map_page import sectionsOf  # noqa: E402
from map_tables import MapResults  # noqa: E402
from report import report  # noqa: E402

if __name__ == '__main__':
    report('maps', MapResults, drawAll, sectionsOf)
