"""The figure of docs/experiments/maps.md."""
from figures import legendBelow, pyplot, save
from map_tables import ALIGNMENTS, RENDERERS, SITES, Scores

TARGET = 0.97
COLOURS = {'sift': '#0072B2', 'correlation': '#009E73', 'trajectory': '#E69F00'}
WIDTH = 0.25


def drawScores(results, path):
    """Resemblance of SLAM's maps, a bar for each alignment, with its spread."""
    sites = results.sites()
    names = ('triangle', 'plain_triangle', 'beam')
    figure, panels = pyplot.subplots(1, len(sites), squeeze=False, sharey=True, figsize=(10, 3.6))
    for axes, site in zip(panels[0], sites):
        for k, alignment in enumerate(ALIGNMENTS):
            scores = [Scores(results.rows('scores'), site=site, renderer=name, source='slam',
                             alignment=alignment) for name in names]
            axes.bar([place + (k - 1) * WIDTH for place in range(len(names))],
                     [100 * (some.mean() or 0.0) for some in scores], WIDTH,
                     yerr=[[100 * (some.mean() - some.least()) if some.rows else 0.0
                            for some in scores], [0.0] * len(names)],
                     color=COLOURS[alignment], label=f'laid on by {alignment}')
        axes.axhline(100 * TARGET, color='#555555', linestyle=':')
        axes.set(title=SITES.get(site, site), ylim=(90, 100), xticks=range(len(names)),
                 xticklabels=[RENDERERS[name].replace(', ', ',\n') for name in names])
    panels[0][0].set_ylabel('resemblance (%)')
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawAll(results, folder):
    if results.rows('scores'):
        drawScores(results, folder / 'scores.png')
