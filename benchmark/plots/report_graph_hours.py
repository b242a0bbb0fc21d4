#!/usr/bin/env python3
"""Draws the plot of the experiments on drives for hours, and writes their tables into the page."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from hours_figures import drawAll  # noqa: E402  (the path comes first)
from hours_page import sectionsOf  # noqa: E402
from report import report  # noqa: E402
from tables import Results  # noqa: E402

if __name__ == '__main__':
    report('graph_hours', Results, drawAll, sectionsOf)
