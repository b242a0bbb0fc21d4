#!/usr/bin/env python3
"""Draws the plots of the exploration experiments, and writes their tables into the page."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from exploration_figures import drawAll  # noqa: E402  (the path comes first)
from exploration_page import sectionsOf  # noqa: E402
from exploration_tables import ExplorationResults  # noqa: E402
from report import report  # noqa: E402

if __name__ == '__main__':
    report('exploration', ExplorationResults, drawAll, sectionsOf)
