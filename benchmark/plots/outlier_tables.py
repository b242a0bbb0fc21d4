"""The tables of the experiments on false loops, as Python sees them."""
import statistics

from tables import Results, column

# Label, colour (by Okabe and Ito) and marker; in the order of the page.
SOLVERS = {
    'doubt': ('doubting loops', '#0072B2', 'o'),
    'scaling': ('dynamic covariance scaling', '#009E73', '^'),
    'graduated': ('graduated non-convexity', '#E69F00', 'D'),
    'cauchy': ('Cauchy', '#56B4E9', 'v'),
    'huber': ('Huber', '#CC79A7', 'x'),
    'plain': ('least squares', '#D55E00', 's'),
}
BOUND = 2.0  # times the clean solution's noise


def labelOf(solver):
    return SOLVERS[solver][0] if solver in SOLVERS else solver


def solversOf(rows):
    known = list(SOLVERS)
    return sorted({row['solver'] for row in rows},
                  key=lambda name: known.index(name) if name in known else len(known))


def graphsOf(rows):
    """Names of graphs, small ones first."""
    return list(dict.fromkeys(row['graph'] for row in sorted(rows, key=lambda row: row['poses'])))


def having(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def isSpoilt(row):
    return row['false_loops'] > 0


class Trials:
    """What some trials with false loops amount to."""

    def __init__(self, rows):
        self.rows = rows
        self.false_loops = round(sum(column(rows, 'false_loops')))
        self.true_loops = round(sum(column(rows, 'true_loops')))
        self.kept = round(sum(column(rows, 'false_kept')))
        self.dropped = round(sum(column(rows, 'true_dropped')))

    def recall(self):
        """Share of the false loops that are named."""
        return (self.false_loops - self.kept) / self.false_loops

    def precision(self):
        """Share of the named loops that are false; None where none is named."""
        named = self.false_loops - self.kept + self.dropped
        return (self.false_loops - self.kept) / named if named else None

    def within(self):
        """Trials with an error below the bound."""
        return sum(row['error'] < BOUND * row['shown_noise'] for row in self.rows)

    def worst(self, key='error'):
        return max(column(self.rows, key))

    def median(self, key='error'):
        return statistics.median(column(self.rows, key))


class OutlierResults(Results):
    """`outliers.csv`."""

    def rows(self):
        return self.table('outliers') if self.has('outliers') else []
