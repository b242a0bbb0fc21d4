"""The tables of the exploration experiments, as the page and the figures want them."""
from statistics import mean

from tables import Results, readTable

# Label, colour; in the order in which they are shown.
STRATEGIES = {
    'nearest_to_robot': ('nearest to robot', '#1f77b4'),
    'nearest_to_origin': ('nearest to origin', '#d62728'),
    'along_route': ('along the route', '#9467bd'),
    'gain_over_cost': ('gain over cost', '#ff7f0e'),
    'tour': ('tour', '#2ca02c'),
    'wall_following': ('wall following', '#7f7f7f'),
}


class ExplorationResults(Results):
    """A folder with runs_<world>.csv, coverage_<world>.csv, paths_<world>.csv, goals_<world>.csv."""

    def worlds(self):
        return sorted(path.stem[len('runs_'):] for path in self.folder.glob('runs_*.csv'))

    def runs(self, world=None, strategy=None):
        worlds = self.worlds() if world is None else [world]
        rows = [row for name in worlds for row in readTable(self.folder / f'runs_{name}.csv')]
        return [row for row in rows if strategy in (None, row['strategy'])]

    def rows(self, kind, world, strategy, seed):
        return [row for row in self.table(kind, world)
                if row['strategy'] == strategy and row['seed'] == seed]


def strategiesOf(rows):
    present = {row['strategy'] for row in rows}
    return [name for name in STRATEGIES if name in present]


def isDone(row):
    return row['ended'] == 1.0 and row['ending'] == 'done'


def meanOf(rows, key):
    return mean(row[key] for row in rows)
