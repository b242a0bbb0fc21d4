"""Draws the plots of a subject, and writes its tables into its page."""
import argparse
import pathlib

from page import fillPage


def report(subject, results_of, draw_all, sections_of):
    """Reads <out>/<subject>/*.csv; writes <out>/<subject>/*.png and <out>/<subject>.md."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--page', type=pathlib.Path, required=True,
                        help='the page, with the text between the tables')
    parser.add_argument('--out', type=pathlib.Path, required=True, help='folder of the results')
    arguments = parser.parse_args()
    results = results_of(arguments.out / subject)
    draw_all(results, results.folder)
    filled = fillPage(arguments.page.read_text(encoding='utf-8'), sections_of(results))
    (arguments.out / f'{subject}.md').write_text(filled, encoding='utf-8')
