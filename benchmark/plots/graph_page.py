"""The tables of docs/experiments/graph.md."""
import math

from graph_tables import KNOWN, Contest, graphsOf, labelOf, solversOf
from page import markdownTable

FIT_FROM = 10000  # poses; below, what does not grow weighs too much
NO_PEERS = 'This run is without GTSAM and g2o: their packages were not there, nor to be had.\n'


def number(value, digits=6):
    return 'failed' if math.isinf(value) else f'{value:.{digits}g}'


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run') or not results.has('solves'):
        return None
    run = results.table('run')[0]
    rows = results.table('solves')
    same = [row for row in rows if all(row[key] == rows[0][key]
                                       for key in ('graph', 'guess', 'solver'))]
    rounds = 'one round' if len(same) == 1 else f'{len(same)} rounds'
    return (f'This page: {rounds}, on {run["date"]}, one of {run["processors"]:.0f} processors '
            f'"{run["processor"]}", {run["compiler"]}, RelWithDebInfo.\n')


def peersSection(results):
    if not results.has('peers'):
        return NO_PEERS if results.has('solves') else None
    packages = [f'{row["package"]} {row["version"]}' for row in results.table('peers')]
    return f'Packages of the peers: {", ".join(packages)}.\n'


def contestRow(graph, contest):
    ours = contest.ours()
    peers = set(solversOf(contest.rows)) - {'ours'}
    peer = contest.fastest(peers)
    cells = [graph, f'{ours["poses"]:.0f}', number(contest.least, 8),
             number(KNOWN[graph], 8) if graph in KNOWN else '-', number(ours['chi_square'], 8),
             f'{ours["milliseconds"]:.2f}']
    if peer is None:
        return cells + ['none', '-', '-', '-']
    with_guess = contest.wholeTime(ours) / contest.wholeTime(
        contest.fastest(peers, contest.wholeTime))
    cells += [f'{labelOf(peer["solver"])}, {peer["guess"]}', f'{peer["milliseconds"]:.2f}']
    if not contest.reaches(ours):
        return cells + ['not reached', '-']
    return cells + [f'{ours["milliseconds"] / peer["milliseconds"]:.2f}', f'{with_guess:.2f}']


def contestSection(results):
    rows = results.rows('solves')
    contests = [(graph, Contest(rows, graph)) for graph in graphsOf(rows)]
    table = [contestRow(graph, contest) for graph, contest in contests if contest.ours()]
    return table and markdownTable(
        ['graph', 'poses', 'least chi-square', 'best known', 'ours', 'ms',
         'fastest peer that reaches it', 'ms', 'ratio', 'with first guesses'], table)


def solvesSection(results):
    rows = results.rows('solves')
    return rows and markdownTable(
        ['graph', 'first guess', 'its chi-square', 'solver', 'chi-square', 'own cost',
         'iterations', 'ms', 'MB'],
        [[row['graph'], row['guess'], number(row['initial_chi_square'], 4),
          labelOf(row['solver']), number(row['chi_square'], 8),
          number(row['own_cost'] if math.isfinite(row['chi_square']) else math.inf, 8),
          f'{row["iterations"]:.0f}', f'{row["milliseconds"]:.2f}', f'{row["peak_mb"]:.0f}']
         for row in rows])


def exponent(rows, key):
    """Slope of log(key) over log(poses), by least squares; None for less than two sizes."""
    large = [row for row in rows if row['poses'] >= FIT_FROM]
    rows = large if len(large) > 1 else rows
    x = [math.log(row['poses']) for row in rows]
    y = [math.log(row[key]) for row in rows]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    spread = sum((value - mean_x) ** 2 for value in x)
    if spread == 0.0:
        return None
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / spread


def ofSolver(rows, solver, guess):
    return [row for row in rows if (row['solver'], row['guess']) == (solver, guess)]


def curvesOf(rows):
    """(solver, guess) of every curve against the size."""
    return sorted({(row['solver'], row['guess']) for row in rows},
                  key=lambda pair: (solversOf(rows).index(pair[0]), pair[1]))


def scalingSection(results):
    rows = results.rows('scaling')
    if not rows:
        return None
    curves = curvesOf(rows)
    heads = [f'{labelOf(solver)}, {guess}' for solver, guess in curves]
    table = []
    for graph in graphsOf(rows):
        here = [row for row in rows if row['graph'] == graph]
        cells = []
        for solver, guess in curves:
            row, = ofSolver(here, solver, guess) or [None]
            cells.append('-' if row is None
                         else f'{row["milliseconds"]:.4g} ms, {row["peak_mb"]:.0f} MB')
        table.append([f'{here[0]["poses"]:,.0f}', f'{here[0]["constraints"]:,.0f}', *cells])
    fits = []
    for solver, guess in curves:
        of_curve = ofSolver(rows, solver, guess)
        slopes = [exponent(of_curve, key) for key in ('milliseconds', 'peak_mb')]
        fits.append('-' if None in slopes else 'n^{:.2f}, n^{:.2f}'.format(*slopes))
    return markdownTable(['poses', 'constraints', *heads], table + [['fit', '', *fits]])


def onlineRow(results, row, least):
    times = results.updates(row['solver'], row['graph'])
    tenth = max(1, len(times) // 10)
    ordered = sorted(times)
    return [row['graph'], labelOf(row['solver']), f'{sum(times) / len(times):.0f}',
            f'{ordered[len(times) // 2]:.0f}', f'{ordered[int(0.99 * len(times))]:.0f}',
            f'{ordered[-1]:.0f}', f'{sum(times[:tenth]) / tenth:.0f}',
            f'{sum(times[-tenth:]) / tenth:.0f}', number(row['chi_square'], 8),
            number(row['own_cost'], 8), number(least, 8)]


def onlineSection(results):
    rows = results.rows('online')
    solves = results.rows('solves')
    if solves and not rows:
        return 'Nothing was played in this run.\n'
    table = [onlineRow(results, row, Contest(solves + [row], row['graph']).least) for row in rows]
    return table and markdownTable(
        ['graph', 'solver', 'mean (µs)', 'median', '99 %', 'worst', 'first tenth', 'last tenth',
         'chi-square at the end', 'own cost', 'least chi-square'], table)


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {
        'run': runSection(results), 'peers': peersSection(results),
        'contest': contestSection(results), 'solves': solvesSection(results),
        'scaling': scalingSection(results), 'online': onlineSection(results),
    }
    return {name: text for name, text in sections.items() if text}
