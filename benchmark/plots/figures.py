"""What the figures of all experiments have in common."""
import matplotlib

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402  (the choice of a backend comes first)

RESOLUTION = 110  # dots an inch
pyplot.rcParams.update({
    'font.size': 10, 'axes.grid': True, 'grid.alpha': 0.3, 'axes.spines.top': False,
    'axes.spines.right': False, 'legend.frameon': False, 'figure.constrained_layout.use': True})


def save(figure, path):
    # Without the version of matplotlib, so that the same tables give the same file.
    figure.savefig(path, dpi=RESOLUTION, bbox_inches='tight', metadata={'Software': None})
    pyplot.close(figure)


def legendBelow(figure, axes):
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc='upper center', bbox_to_anchor=(0.5, 0.0), ncol=4)
