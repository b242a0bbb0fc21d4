"""The tables of the experiments on the graph's solver, as Python sees them."""
from tables import Results

# Label and colour (by Okabe and Ito), marker; in the order of the page.
SOLVERS = {
    'ours': ('ours', '#0072B2', 'o'),
    'g2o_gn': ('g2o Gauss-Newton', '#D55E00', 's'),
    'gtsam_gn': ('GTSAM Gauss-Newton', '#009E73', '^'),
    'gtsam_lm': ('GTSAM Levenberg-Marquardt', '#56B4E9', 'v'),
    'ceres': ('Ceres Levenberg-Marquardt', '#E69F00', 'D'),
    'isam2': ('GTSAM iSAM2', '#009E73', '^'),
}
GUESSES = ['best', 'odometry', 'tree', 'chordal']
REACHED = 1e-3  # a solver reaches the least chi-square if it ends no farther above, as a share
# The least chi-squares known, found by many solvers from many guesses.
KNOWN = {'intel': 45.0047, 'CSAIL': 40.5551, 'MIT': 41.1633, 'manhattan': 3549.0368,
         'city10000': 511.9852}


def labelOf(solver):
    return SOLVERS[solver][0] if solver in SOLVERS else solver


def styleOf(solver):
    label, colour, marker = SOLVERS.get(solver, (solver, '#CC79A7', 'x'))
    return {'color': colour, 'marker': marker, 'label': label}


def place(name, names):
    known = list(names)
    return known.index(name) if name in known else len(known)


def solversOf(rows):
    return sorted({row['solver'] for row in rows}, key=lambda name: place(name, SOLVERS))


def graphsOf(rows):
    """Names of graphs, small ones first."""
    return list(dict.fromkeys(row['graph'] for row in sorted(rows, key=lambda row: row['poses'])))


def leastOfRounds(rows):
    """A row for each graph, guess and solver: the least time of all rounds, each a median.

    In the order of the page.
    """
    found = {}
    for row in rows:
        key = (row['graph'], row['guess'], row['solver'])
        if key not in found or row['milliseconds'] < found[key]['milliseconds']:
            found[key] = row
    return sorted(found.values(), key=lambda row: (
        row['poses'], row['graph'], place(row['guess'], GUESSES), place(row['solver'], SOLVERS)))


class GraphResults(Results):
    """`solves.csv`, `scaling.csv`, `online.csv` and `online_<solver>_<graph>.csv`."""

    def rows(self, what):
        return leastOfRounds(self.table(what)) if self.has(what) else []

    def updates(self, solver, graph):
        """Microseconds of each update, in their order."""
        return [row['microseconds'] for row in self.table('online', solver, graph)]


class Contest:
    """All solvers on one graph."""

    def __init__(self, rows, graph):
        self.rows = [row for row in rows if row['graph'] == graph]
        self.least = min(row['chi_square'] for row in self.rows)

    def reaches(self, row):
        return row['chi_square'] <= (1.0 + REACHED) * self.least

    def ours(self):
        """Ours as it is by default."""
        return next((row for row in self.rows if row['solver'] == 'ours'
                     and row['guess'] == 'best'), None)

    def fastest(self, solvers, time=lambda row: row['milliseconds']):
        """The row of those solvers that reaches the least chi-square soonest; None without any."""
        rows = [row for row in self.rows if row['solver'] in solvers and self.reaches(row)]
        return min(rows, key=time, default=None)

    def wholeTime(self, row):
        """Of a solve and its first guess, which is ours, whichever solver goes on from it [ms]."""
        guess = next((other['guess_milliseconds'] for other in self.rows
                      if other['solver'] == 'ours' and other['guess'] == row['guess']), 0.0)
        return row['milliseconds'] + guess
