#!/usr/bin/env python3
"""Draws the plot of the experiments on false loops, and writes their tables into the page."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from outlier_figures import drawAll  # noqa: E402  (the path comes first)
from outlier_page import sectionsOf  # noqa: E402
from outlier_tables import OutlierResults  # noqa: E402
from report import report  # noqa: E402

if __name__ == '__main__':
    report('graph_outliers', OutlierResults, drawAll, sectionsOf)
