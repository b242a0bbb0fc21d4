"""The figure of docs/experiments/graph_hours.md."""
from figures import legendBelow, pyplot, save
from tables import column

# Label and colour (by Okabe and Ito), by table.
DRIVES = {'thinned': ('keyframes retire', '#0072B2'), 'kept': ('all are kept', '#D55E00')}


def drawHours(results, path):
    """The size of the graph, the time of an update and the memory against hours."""
    figure, panels = pyplot.subplots(1, 3, figsize=(10, 3.6))
    for name, (label, colour) in DRIVES.items():
        rows = results.table(name) if results.has(name) else []
        hours = range(1, len(rows) + 1)
        panels[0].plot(hours, column(rows, 'estimated'), color=colour, marker='o', label=label)
        for key, style in (('mean_ms', '-'), ('p99_ms', ':')):
            of_key = label if key == 'mean_ms' else f'{label}, 99 %'
            panels[1].plot(hours, column(rows, key), color=colour, linestyle=style, label=of_key)
        panels[2].plot(hours, column(rows, 'memory_mb'), color=colour, marker='o')
    for axes, label in zip(panels, ('keyframes estimated', 'an update (ms)', 'memory (MB)')):
        axes.set(xlabel='hours', ylabel=label, xlim=(0, None), ylim=(0, None))
    legendBelow(figure, panels[1])
    save(figure, path)


def drawAll(results, folder):
    if results.has('thinned'):
        drawHours(results, folder / 'hours.png')
