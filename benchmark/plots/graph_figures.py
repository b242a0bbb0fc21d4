"""The figures of docs/experiments/graph.md, one function each."""
from figures import legendBelow, pyplot, save
from graph_page import curvesOf, exponent, ofSolver
from graph_tables import Contest, graphsOf, labelOf, solversOf, styleOf
from tables import column

WINDOWS = 60  # of a drive, in each of which updates are summed up


def drawContest(results, path):
    """The time to the least chi-square: ours by default, peers from what suits them best."""
    rows = results.rows('solves')
    graphs = graphsOf(rows)
    contests = [Contest(rows, graph) for graph in graphs]
    figure, axes = pyplot.subplots(figsize=(10, 4.4))
    for solver in solversOf(rows):
        found = [(place, contest.ours() if solver == 'ours' else contest.fastest({solver}))
                 for place, contest in enumerate(contests)]
        points = [(place, row['milliseconds']) for place, row in found
                  if row is not None and contests[place].reaches(row)]
        if points:
            axes.plot(*zip(*points), linestyle='none', markersize=8, alpha=0.85,
                      **styleOf(solver))
    axes.set(yscale='log', ylabel='solve alone (ms)')
    sizes = [contest.rows[0]['poses'] for contest in contests]
    axes.set_xticks(range(len(graphs)),
                    [f'{graph}\n{size:.0f} poses' for graph, size in zip(graphs, sizes)],
                    fontsize=8)
    legendBelow(figure, axes)
    save(figure, path)


def drawScaling(results, path):
    """Time and memory against the size of the graph."""
    rows = results.rows('scaling')
    figure, panels = pyplot.subplots(1, 2, figsize=(10, 4.2))
    for axes, key, label in ((panels[0], 'milliseconds', 'solve alone (ms)'),
                             (panels[1], 'peak_mb', 'peak memory of the process (MB)')):
        for solver, guess in curvesOf(rows):
            curve = ofSolver(rows, solver, guess)
            style = styleOf(solver)
            slope = exponent(curve, key)
            style['label'] = f'{labelOf(solver)}, {guess}' + (
                f': n^{slope:.2f}' if slope is not None else '')
            axes.plot(column(curve, 'poses'), column(curve, key),
                      linestyle='--' if guess == 'best' else '-', **style)
        axes.set(xscale='log', yscale='log', xlabel='poses', ylabel=label)
        axes.legend(fontsize=8)
    save(figure, path)


def quantiles(times):
    """(end, median, 99th percentile) of each window of a drive."""
    size = max(1, len(times) // WINDOWS)
    found = []
    for start in range(0, len(times), size):
        window = sorted(times[start:start + size])
        found.append((start + len(window), window[len(window) // 2],
                      window[int(0.99 * len(window))]))
    return found


def drawOnline(results, path):
    """What an update takes as the graph grows."""
    rows = results.rows('online')
    graphs = graphsOf(rows)
    figure, panels = pyplot.subplots(1, len(graphs), figsize=(10, 4.2), squeeze=False)
    for axes, graph in zip(panels[0], graphs):
        for row in rows:
            if row['graph'] == graph:
                style = {**styleOf(row['solver']), 'marker': ''}
                ends, medians, highest = zip(*quantiles(results.updates(row['solver'], graph)))
                axes.plot(ends, medians, **style)
                axes.plot(ends, highest, **{**style, 'label': style['label'] + ', 99 %'},
                          linestyle=':')
        axes.set(yscale='log', xlabel='poses so far', title=graph)
    panels[0][0].set_ylabel('an update (µs)')
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawAll(results, folder):
    """@return names of the files drawn"""
    drawn = []
    for what, function in (('solves', drawContest), ('scaling', drawScaling),
                           ('online', drawOnline)):
        if results.rows(what):
            drawn.append(function.__name__[len('draw'):].lower() + '.png')
            function(results, folder / drawn[-1])
    return drawn
