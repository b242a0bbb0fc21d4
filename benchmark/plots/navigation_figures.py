"""The plot of docs/experiments/navigation.md."""
import matplotlib
from navigation_page import byKey

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402  (the backend comes first)


def drawAll(results, folder):
    """Times against lengths of plans, and how much longer than the shortest they are."""
    if not results.has('queries'):
        return
    figure, (times, lengths) = pyplot.subplots(1, 2, figsize=(9, 3.6))
    for world, rows in byKey(results.table('queries'), 'world').items():
        found = [row for row in rows if row['found'] and row['has_way'] and row['shortest'] > 0.5]
        times.plot([row['length'] for row in found], [row['milliseconds'] for row in found], '.',
                   markersize=3, label=world)
        ratios = sorted(row['length'] / row['shortest'] for row in found)
        lengths.plot(ratios, [(i + 1) / len(ratios) for i in range(len(ratios))], label=world)
    times.set(xlabel='length of the plan (m)', ylabel='time (ms)', yscale='log')
    lengths.set(xlabel="length / shortest way over the grid", ylabel='share of plans')
    lengths.legend()
    for axes in (times, lengths):
        axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(folder / 'plans.png', dpi=110)
    pyplot.close(figure)
