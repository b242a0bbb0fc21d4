"""The figures of docs/experiments/exploration.md."""
from exploration_tables import STRATEGIES, strategiesOf
from figures import legendBelow, pyplot, save
from tables import column


def drawCoverage(results, world, path):
    """Coverage over time, a line a run."""
    figure, axes = pyplot.subplots(figsize=(8, 4))
    runs = results.runs(world)
    for strategy in strategiesOf(runs):
        label, colour = STRATEGIES[strategy]
        for run in results.runs(world, strategy):
            rows = results.rows('coverage', world, strategy, run['seed'])
            axes.plot(column(rows, 'time'), [100.0 * share for share in column(rows, 'coverage')],
                      color=colour, label=label, linewidth=1.2)
            label = None
    axes.set(xlabel='time [s]', ylabel='seen of what can be seen [%]', title=world)
    legendBelow(figure, axes)
    save(figure, path)


def drawPaths(results, world, path):
    """The true path of the first run of each strategy, as the paper's figures 7 and 8."""
    strategies = strategiesOf(results.runs(world))
    figure, panels = pyplot.subplots(1, len(strategies), squeeze=False,
                                     figsize=(3.2 * len(strategies), 4.2), sharex=True, sharey=True)
    for axes, strategy in zip(panels[0], strategies):
        label, colour = STRATEGIES[strategy]
        run = results.runs(world, strategy)[0]
        rows = results.rows('paths', world, strategy, run['seed'])
        axes.plot(column(rows, 'x'), column(rows, 'y'), color=colour, linewidth=0.9)
        axes.plot(rows[0]['x'], rows[0]['y'], 'ko', markersize=4)
        axes.set(aspect='equal', xlabel='x [m]',
                 title=f'{label}\n{run["time"]:.0f} s, {run["distance"]:.0f} m')
    panels[0][0].set_ylabel('y [m]')
    save(figure, path)


def drawDetectors(results, path):
    figure, axes = pyplot.subplots(figsize=(6, 4))
    rows = results.table('detectors')
    for key, label, colour in (('everything', 'all cells', '#d62728'),
                               ('wavefront', 'wavefront', '#1f77b4'),
                               ('fast', 'fast, one sweep', '#2ca02c')):
        axes.plot(column(rows, 'size'), column(rows, key), color=colour, marker='o', label=label)
    axes.set(xscale='log', yscale='log', xlabel='edge of the map [cells]', ylabel='time [ms]')
    axes.legend()
    save(figure, path)


def drawAll(results, folder):
    for world in results.worlds():
        drawCoverage(results, world, folder / f'coverage_{world}.png')
        drawPaths(results, world, folder / f'paths_{world}.png')
    if results.has('detectors'):
        drawDetectors(results, folder / 'detectors.png')
