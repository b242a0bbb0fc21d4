"""The figure of docs/experiments/graph_outliers.md."""
from figures import legendBelow, pyplot, save
from outlier_tables import BOUND, SOLVERS, Trials, graphsOf, having, isSpoilt, solversOf

LEAST = 1e-4  # of the noise; errors below are drawn there


def drawCurve(axes, rows, solver):
    label, colour, marker = SOLVERS[solver]
    counts = sorted({row['false_loops'] for row in rows})
    trials = [Trials(having(rows, false_loops=count)) for count in counts]
    noise = rows[0]['shown_noise']
    axes.plot(counts, [max(some.worst() / noise, LEAST) for some in trials], color=colour,
              marker=marker, label=label)


def drawErrors(results, path):
    """The worst error of all trials against the number of false loops, in units of the noise."""
    rows = list(filter(isSpoilt, results.rows()))
    graphs = [graph for graph in graphsOf(rows) if len(solversOf(having(rows, graph=graph))) > 1]
    groups = sorted({row['group'] for row in rows})
    figure, panels = pyplot.subplots(len(graphs), len(groups), squeeze=False, sharex=True,
                                     sharey=True, figsize=(10, 3.4 * len(graphs)))
    for line, graph in zip(panels, graphs):
        for axes, group in zip(line, groups):
            here = having(rows, graph=graph, group=group)
            for solver in solversOf(here):
                drawCurve(axes, having(here, solver=solver), solver)
            axes.axhline(BOUND, color='#555555', linestyle=':')
            axes.set(yscale='log', title=f'{graph}, ' + (
                'alone' if group == 1 else f'groups of {group:.0f} that agree'))
        line[0].set_ylabel('worst error / noise')
    for axes in panels[-1]:
        axes.set_xlabel('false loops')
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawAll(results, folder):
    if results.rows():
        drawErrors(results, folder / 'errors.png')
