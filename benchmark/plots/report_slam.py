#!/usr/bin/env python3
"""Draws the plots of the experiments on SLAM, and writes their tables into the page."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from report import report  # noqa: E402  (the path comes first)
from slam_figures import drawAll  # noqa: E402
from slam_page import sectionsOf  # noqa: E402
from slam_tables import SlamResults  # noqa: E402

if __name__ == '__main__':
    report('slam', SlamResults, drawAll, sectionsOf)
