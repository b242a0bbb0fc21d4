"""The tables of the experiments on maps, as Python sees them."""
import re

from outlier_tables import having
from tables import Results, column

RENDERERS = {'triangle': 'triangle', 'plain_triangle': "triangle, the paper's plain rule",
             'beam': 'beam', 'beam_keeping_people': 'beam, people are not forgotten',
             'mrpt': 'MRPT'}
SOURCES = {'slam': 'SLAM, noise on', 'true_poses': 'true poses, noise on',
           'no_noise': 'true poses, no noise'}
ALIGNMENTS = ('sift', 'correlation', 'trajectory')
AGGREGATES = ('_mean', '_median', '_stddev', '_cv')  # of Google Benchmark, over the rounds
SITES = {'swarmlab': 'SwarmLab', 'lab': 'lab'}


def mean(values):
    return sum(values) / len(values)


class MapResults(Results):
    """`surveys.csv`, `scores.csv`, `peer.csv` and `times.csv`."""

    def times(self):
        """What was timed -> its fastest round, a row as Google Benchmark has written it."""
        fastest = {}
        for row in self.rows('times'):
            name = re.sub('/(iterations:|min_time:|repeats:|manual_time).*', '', row['name'])
            if row['name'].endswith(AGGREGATES):
                continue
            if name not in fastest or row['real_time'] < fastest[name]['real_time']:
                fastest[name] = row
        return fastest

    def rows(self, name):
        return self.table(name) if self.has(name) else []

    def sites(self):
        found = {row['site'] for row in self.rows('scores')}
        return [site for site in SITES if site in found] + sorted(found - set(SITES))


class Scores:
    """What some maps have in common, at one alignment."""

    def __init__(self, rows, **wanted):
        self.all = having(rows, **wanted)
        self.rows = having(self.all, aligned=1.0)

    def mean(self, key='score'):
        return mean(column(self.rows, key)) if self.rows else None

    def least(self, key='score'):
        return min(column(self.rows, key)) if self.rows else None
