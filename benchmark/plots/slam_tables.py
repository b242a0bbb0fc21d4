"""The tables of the experiments on SLAM as a whole, as Python sees them."""
from tables import Results

# How pages speak of logs and worlds; in their order.
LOGS = {
    'intel_first': 'Intel, first 1088 s',
    'intel_full': 'Intel, whole run',
    'csail': 'MIT CSAIL',
    'aces': 'ACES',
    'freiburg_101': 'Freiburg 101',
    'mines': 'Paris Mines',
}
GOOD_ERROR = 0.05  # [m] of a simulated drive

# Others on the very same files, scored by the same rule: error [m] and turn [deg]; measured once, on
# 2026-11-22, on a machine like the one that the page names.
PEERS = {
    'intel_first': {
        'gmapping': (0.044, 1.77), 'Karto': (0.046, 1.11), 'slam_toolbox': (0.124, 1.66),
        'Cartographer, tuned to these logs': (0.044, 0.60), 'Hector with odometry': (0.0198, 0.29)},
    'intel_full': {
        'gmapping': (0.074, 2.81), 'Karto': (0.069, 1.69), 'slam_toolbox': (0.099, 1.52),
        'Cartographer, tuned to these logs': None, 'Hector with odometry': (0.065, 1.62)},
}
# Their processor seconds for a log, then and there.
COSTS = {
    'intel_first': {'gmapping': 72, 'Karto': 24, 'slam_toolbox': 9},
    'intel_full': {'gmapping': 166, 'Karto': 62, 'slam_toolbox': 28},
    'csail': {'gmapping': 129, 'Karto': 30, 'slam_toolbox': 13},
}
GOALS = {'intel_first': (0.0190, 0.28), 'intel_full': (0.055, 1.40)}


def having(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def inOrder(rows, key, order):
    """Rows sorted by where the value of a key stands in a list; strangers last, by name."""
    names = list(order)
    return sorted(rows, key=lambda row: (names.index(row[key]) if row[key] in names
                                         else len(names), str(row[key])))


def isKnown(value):
    return isinstance(value, float) and value == value  # NaN is not


def trueShare(row):
    """Of the loops found, those that the final solution does not violate; None without loops."""
    return 1.0 - row['violated'] / row['loops'] if row['loops'] else None


def isGood(row):
    """A simulated drive that kept its place, and believed no false loop."""
    return row['error'] < GOOD_ERROR and row['false_loops'] == 0


class SlamResults(Results):
    """A table for each part, or more, and `run_<part>.csv` that says when and where."""

    def rows(self, name):
        return self.table(name) if self.has(name) else []

    def drives(self):
        """(world, laser, noise) -> rows, a row a seed."""
        groups = {}
        for row in self.rows('simulation'):
            groups.setdefault((row['world'], row['laser'], row['noise']), []).append(row)
        return groups
