"""The figures of docs/experiments/matching.md, one function each."""
import math

from figures import legendBelow, pyplot, save
from matching_tables import SOURCES, WORLDS, byMatcher, styleOf
from tables import column

NOISES = {'translation': 'odometry off by (m)', 'rotation': 'odometry off by (rad)'}
VALLEY = 0.01  # m^2; shallower ones come from the noise of the ranges
AXIS_OF_NOISE = {'translation': 1.0, 'rotation': math.pi}


def quote(axes, text, **place):
    """What the paper says, where it says it."""
    axes.annotate(text, fontsize=8, color='#555555', style='italic',
                  arrowprops={'arrowstyle': '->', 'color': '#999999'}, **place)


def drawErrors(results, path):
    """Figures 9 and 10: squared error against displacement, the mean of many scans."""
    figure, panels = pyplot.subplots(1, 2, figsize=(10, 3.8))
    for world in results.worlds('errors'):
        rows = results.table('errors', world)
        for axes, kind in zip(panels, NOISES):
            of_kind = [row for row in rows if row['kind'] == kind]
            axes.plot(column(of_kind, 'displacement'), column(of_kind, 'squared_error'),
                      label=WORLDS.get(world, world))
    panels[0].set(xlabel='displacement (m)', ylabel='mean squared error of a ray (m²)',
                  title='displaced (paper: figure 9)')
    panels[1].set(xlabel='rotation (rad)', title='rotated (paper: figure 10)')
    panels[1].axvline(2.5, color='#999999', linestyle=':')
    top = panels[1].get_ylim()[1]
    quote(panels[1], 'paper: plateaus\naround 2.5 rad', xy=(2.5, 0.45 * top),
          xytext=(1.6, 0.12 * top))
    panels[0].legend()
    save(figure, path)


def localMinima(values, depth):
    """Indices of the valleys that one must climb by `depth` to leave, on either side."""
    minima = []
    falling = True
    lowest = 0
    highest = values[0]
    for k, value in enumerate(values):
        if falling and value < values[lowest]:
            lowest = k
        elif falling and value >= values[lowest] + depth:
            if lowest > 0:
                minima.append(lowest)
            falling, highest = False, value
        elif not falling and value > highest:
            highest = value
        elif not falling and value <= highest - depth:
            falling, lowest = True, k
    return minima


def singleScan(results, world):
    """(angles, errors) of the scan of figure 11."""
    rows = [row for row in results.table('errors', world) if row['kind'] == 'single']
    return column(rows, 'displacement'), column(rows, 'squared_error')


def drawSingle(results, path):
    """Figure 11: one scan turned all the way round."""
    worlds = results.worlds('errors')
    figure, panels = pyplot.subplots(1, len(worlds), figsize=(10, 3.4), squeeze=False)
    for axes, world in zip(panels[0], worlds):
        angles, errors = singleScan(results, world)
        minima = localMinima(errors, VALLEY)
        axes.plot(angles, errors, color='#0072B2', linewidth=1.0)
        axes.plot([angles[k] for k in minima], [errors[k] for k in minima], '.',
                  color='#D55E00', label=f'{len(minima)} local minima')
        axes.set(xlabel='rotation (rad)', title=f'{WORLDS.get(world, world)} (paper: figure 11)')
        axes.legend(loc='upper right')
    panels[0][0].set_ylabel('squared error of a ray (m²)')
    save(figure, path)


def drawAgainstNoise(results, noise, keys, path):
    """A column of panels for each world, a row for each (key, label, range) of `keys`."""
    worlds = [world for world in results.worlds('elimination')
              if results.has('elimination', world, noise)]
    figure, panels = pyplot.subplots(len(keys), len(worlds), squeeze=False, sharex=True,
                                     figsize=(10, 3.2 * len(keys) + 0.8))
    for column_index, world in enumerate(worlds):
        matchers = byMatcher(results.table('elimination', world, noise))
        for axes, (key, label, limits) in zip(panels[:, column_index], keys):
            for name, rows in matchers.items():
                if name != 'information' or key.startswith('quotient'):
                    axes.plot(column(rows, 'level'), column(rows, key), linewidth=1.4,
                              **styleOf(name))
            axes.set(xlim=(0.0, AXIS_OF_NOISE[noise]), ylim=limits)
            if column_index == 0:
                axes.set_ylabel(label)
        panels[0][column_index].set_title(WORLDS.get(world, world))
        panels[-1][column_index].set_xlabel(NOISES[noise])
    return figure, panels


def drawQuotient(results, noise, path):
    """Figures 15 to 20: what a match takes away of the squared error."""
    keys = [('quotient_determined', 'error elimination quotient', (-0.15, 1.03))]
    figure, panels = drawAgainstNoise(results, noise, keys, path)
    for axes in panels[0]:
        axes.axhline(0.95, color='#999999', linewidth=0.8)
        axes.axhline(0.0, color='#999999', linewidth=0.8)
    if noise == 'translation':
        quote(panels[0][0], 'paper: particle sampling\nhelps no more', xy=(0.25, 0.0),
              xytext=(0.3, 0.12))
        quote(panels[0][0], 'paper: hill climbing\nhelps no more', xy=(1.0, 0.0),
              xytext=(0.66, 0.12))
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawWithin(results, noise, path):
    """The share of matches that end at the truth."""
    keys = [('within_determined', 'share within 5 cm and 1°', (0.0, 1.03))]
    figure, panels = drawAgainstNoise(results, noise, keys, path)
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawTrust(results, noise, path):
    """What matchers say of themselves."""
    keys = [('trusted', 'share trusted', (0.0, 1.03)),
            ('trusted_wrong', 'share trusted and wrong', (0.0, None))]
    figure, panels = drawAgainstNoise(results, noise, keys, path)
    legendBelow(figure, panels[0][0])
    save(figure, path)


def drawReliability(results, path):
    """How often a match is right, against how long it takes."""
    sources = results.worlds('reliability')
    figure, panels = pyplot.subplots(1, len(sources), figsize=(10, 4.2), squeeze=False)
    for axes, source in zip(panels[0], sources):
        times = {row['matcher']: row['of_pcl_icp'] for row in results.table('speed', source)
                 if row['guess'] == 'near'}
        rows = [row for row in results.table('reliability', source) if row['guess'] == 'near']
        for name, found in byMatcher(rows).items():
            style = styleOf(name)
            axes.plot(times[name], 100.0 * found[0]['within'], 'o', color=style['color'],
                      label=style['label'])
            axes.annotate(style['label'], (times[name], 100.0 * found[0]['within']),
                          textcoords='offset points', xytext=(6, -10), fontsize=9)
        axes.set(xscale='log', xlabel='time of a match, PCL ICP = 1', title=SOURCES[source])
        axes.margins(x=0.2, y=0.1)
    panels[0][0].set_ylabel('within 0.1 m and 2° (%)')
    save(figure, path)


def drawAll(results, folder):
    """@return names of the files drawn"""
    drawn = []

    def draw(function, *arguments):
        name = '_'.join([function.__name__[len('draw'):].lower(), *arguments]) + '.png'
        function(results, *arguments, folder / name)
        drawn.append(name)

    if results.worlds('errors'):
        draw(drawErrors)
        draw(drawSingle)
    for noise in NOISES:
        if any(results.has('elimination', world, noise) for world in results.worlds('elimination')):
            for function in (drawQuotient, drawWithin, drawTrust):
                draw(function, noise)
    if results.worlds('reliability'):
        draw(drawReliability)
    return drawn
