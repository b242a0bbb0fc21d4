"""The tables of docs/experiments/graph_outliers.md."""
from outlier_tables import Trials, graphsOf, having, isSpoilt, labelOf, solversOf
from page import markdownTable, percent


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run') or not results.rows():
        return None
    run = results.table('run')[0]
    seeds = len({row['seed'] for row in results.rows() if row['false_loops'] == 10.0})
    return (f'This page: {seeds} trials of each kind, on {run["date"]}, one of '
            f'{run["processors"]:.0f} processors "{run["processor"]}", {run["compiler"]}, '
            'RelWithDebInfo.\n')


def metres(value):
    return f'{value:.3f} m' if value >= 0.0005 else 'below 1 mm'


def share(value):
    return '-' if value is None else percent(value, 2)


def namedSection(results):
    """How the solver that doubts loops fares, by kinds of false loops."""
    rows = list(filter(isSpoilt, having(results.rows(), solver='doubt')))
    table = []
    for graph in graphsOf(rows):
        of_graph = having(rows, graph=graph)
        kinds = sorted({(row['group'], row['false_loops']) for row in of_graph})
        for group, count in kinds:
            trials = Trials(having(of_graph, group=group, false_loops=count))
            table.append([graph, f'{count:.0f}', 'alone' if group == 1 else f'by {group:.0f}',
                          f'{trials.kept} of {trials.false_loops:,}',
                          f'{trials.dropped} of {trials.true_loops:,}', share(trials.precision()),
                          share(trials.recall()), metres(trials.median()), metres(trials.worst()),
                          metres(trials.rows[0]['shown_noise']),
                          f'{trials.within()} of {len(trials.rows)}',
                          f'{trials.median("milliseconds"):.0f}'])
    return table and markdownTable(
        ['graph', 'false loops', 'in groups', 'believed', 'true ones withdrawn', 'precision',
         'recall', 'median error', 'worst error', 'noise', 'error below 2 x noise', 'ms'], table)


def solversSection(results):
    """All solvers, over all kinds of false loops."""
    rows = list(filter(isSpoilt, results.rows()))
    table = []
    for graph in graphsOf(rows):
        solvers = solversOf(having(rows, graph=graph))
        for solver in solvers if len(solvers) > 1 else []:
            trials = Trials(having(rows, graph=graph, solver=solver))
            table.append([graph, labelOf(solver), f'{trials.within()} of {len(trials.rows)}',
                          metres(trials.median()), metres(trials.worst()),
                          share(trials.precision()), share(trials.recall()),
                          f'{trials.median("milliseconds"):.0f}'])
    return table and markdownTable(
        ['graph', 'solver', 'error below 2 x noise', 'median error', 'worst error', 'precision',
         'recall', 'ms'], table)


def cleanSection(results):
    """What doubt costs where there is nothing to doubt."""
    rows = having(results.rows(), false_loops=0.0)
    table = []
    for graph in graphsOf(rows):
        doubting = having(rows, graph=graph, solver='doubt')
        plain = having(rows, graph=graph, solver='plain')
        if doubting and plain:
            one, other = doubting[0], plain[0]
            table.append([graph, f'{one["poses"]:.0f}', f'{one["true_loops"]:.0f}',
                          f'{one["true_dropped"]:.0f}', metres(one['error']),
                          f'{one["milliseconds"]:.0f}', f'{other["milliseconds"]:.0f}',
                          f'{one["milliseconds"] / other["milliseconds"]:.1f}'])
    return table and markdownTable(
        ['graph', 'poses', 'loops', 'withdrawn', 'error', 'doubting loops (ms)',
         'least squares (ms)', 'ratio'], table)


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {'run': runSection(results), 'named': namedSection(results),
                'solvers': solversSection(results), 'clean': cleanSection(results)}
    return {name: text for name, text in sections.items() if text}
