"""The tables of docs/experiments/matching.md."""
from matching_tables import WORLDS, byMatcher, labelOf
from page import markdownTable, percent
from tables import column

# Section 7.3 of the paper: what its matchers did, and the seconds of their 31,500 matches.
PAPER = {
    'hill_climbing': ('95 % only at extremely low noise, nothing at 1.0', 441),
    'particles': ('nothing from 0.25 on', 918),
    'icp': ('falls off sooner than hill climbing', 99),
}
GOAL = 0.95
TOLERATED = 1e-9


def nearest(rows, level):
    """The row whose level is nearest."""
    return min(rows, key=lambda row: abs(row['level'] - level))


def stretchAbove(rows, key, goal):
    """The longest run of levels with a value of at least `goal`, as text."""
    best = (0.0, None)
    begin = None
    for row in rows + [None]:
        if row is not None and row[key] >= goal - TOLERATED:
            begin = row if begin is None else begin
            last = row
        elif begin is not None:
            best = max(best, (last['level'] - begin['level'] + TOLERATED,
                              (begin['level'], last['level'])), key=lambda item: item[0])
            begin = None
    return 'nowhere' if best[1] is None else f'{best[1][0]:.2f} to {best[1][1]:.2f}'


def worldName(world):
    return WORLDS.get(world, world)


def placesSection(results, noise):
    rows = []
    for world in results.worlds('places'):
        if results.has('places', world, noise):
            row = results.table('places', world, noise)[0]
            rows.append([worldName(world), *(f'{row[key]:.0f}' for key in (
                'places', 'determined', 'too_few_returns', 'open_direction'))])
    return rows and markdownTable(['world', 'places', 'determine a pose', 'too few returns',
                                   'a direction is open'], rows)


def quotientSection(results, noise, levels):
    rows = []
    for world in results.worlds('elimination'):
        if not results.has('elimination', world, noise):
            continue
        for matcher, found in byMatcher(results.table('elimination', world, noise)).items():
            rows.append([worldName(world), labelOf(matcher),
                         *(f'{nearest(found, level)["quotient_determined"]:.3f}'
                           for level in levels),
                         stretchAbove(found, 'quotient_determined', GOAL)])
    return rows and markdownTable(
        ['world', 'matcher', *(f'at {level:g}' for level in levels), '95 % or more from'], rows)


def reliabilityOf(found):
    """Cells on how many matches of a curve end at the truth."""
    matches = sum(column(found, 'matches'))
    determined = sum(column(found, 'determined'))

    def mean(key, weight):
        return sum(row[key] * row[weight] for row in found) / max(matches if weight == 'matches'
                                                                   else determined, 1.0)
    worst = min(column(found, 'within_determined'))
    return [percent(mean('within', 'matches')), percent(mean('within_determined', 'determined')),
            percent(worst), percent(mean('trusted', 'matches')),
            percent(mean('trusted_wrong', 'matches'), 2)]


def withinSection(results, noise):
    rows = []
    for world in results.worlds('elimination'):
        if results.has('elimination', world, noise):
            rows += [[worldName(world), labelOf(matcher), *reliabilityOf(found)]
                     for matcher, found in
                     byMatcher(results.table('elimination', world, noise)).items()
                     if matcher != 'information']
    return rows and markdownTable(
        ['world', 'matcher', 'within, of all', 'within, of determined', 'at the worst level',
         'trusted', 'trusted and wrong'], rows)


def paperSection(results, noise):
    """Paper beside ours, on the SwarmLab where it was measured."""
    worlds = [world for world in results.worlds('elimination')
              if results.has('elimination', world, noise)]
    if not worlds:
        return None
    world = 'swarmlab' if 'swarmlab' in worlds else worlds[0]
    seconds = {row['matcher']: row for row in results.table('seconds', world, noise)}
    rows = []
    for matcher, found in byMatcher(results.table('elimination', world, noise)).items():
        if matcher not in seconds:
            continue
        said, took = PAPER.get(matcher, ('-', None))
        at = [f'{nearest(found, level)["quotient_determined"]:.3f}' for level in (0.25, 1.0)]
        rows.append([labelOf(matcher), said, *at, f'{took} s' if took else '-',
                     f'{seconds[matcher]["seconds"]:.0f} s'])
    matches = f'{seconds[next(iter(seconds))]["matches"]:,.0f}'
    return markdownTable(['matcher', 'the paper on its quotient', 'ours at 0.25 m', 'ours at 1 m',
                          'its 31,500 matches', f'our {matches}'], rows)


def consistencySection(results):
    rows = []
    for world in results.worlds('consistency'):
        for row in results.table('consistency', world):
            rows.append([worldName(world), labelOf(row['matcher']),
                         percent(row['trusted'] / row['pairs']), percent(row['inside'], 2),
                         f'{row["mean_squared_length"]:.2f}',
                         percent(row['inside_of_claiming'], 2)])
    return rows and markdownTable(
        ['world', 'matcher', 'trusted', 'of these inside 3 sigma', 'mean squared length',
         'inside, open directions included'], rows)


def reliabilitySection(results, source, guess):
    if not results.has('reliability', source):
        return None
    times = {row['matcher']: row for row in results.table('speed', source)
             if row['guess'] == guess}
    found = [row for row in results.table('reliability', source) if row['guess'] == guess]
    rows = [[labelOf(name), f'{times[name]["of_pcl_icp"]:.3f}', percent(row['within']),
             percent(row['within_determined']), percent(row['trusted']),
             percent(row['trusted_wrong'])]
            for name, (row,) in byMatcher(found).items()]
    head = f'{found[0]["pairs"]:.0f} pairs, {found[0]["determined"]:.0f} determined'
    return markdownTable(['matcher', 'time', 'within, of all', 'within, of determined', 'trusted',
                          'trusted and wrong'], rows) + f'\n{head}.\n'


def runSection(results):
    """What the page is of, in a sentence."""
    worlds = results.worlds('places')
    if not worlds or not results.has('run'):
        return None
    run = results.table('run')[0]
    places = results.table('places', worlds[0], 'translation')[0]['places']
    levels = {row['level'] for row in results.table('elimination', worlds[0], 'translation')}
    return (f'This page: {places:.0f} places, {len(levels)} levels, on {run["date"]}, one of '
            f'{run["processors"]:.0f} processors "{run["processor"]}", {run["compiler"]}, '
            'RelWithDebInfo.\n')


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {
        'run': runSection(results),
        'places': placesSection(results, 'translation'),
        'paper': paperSection(results, 'translation'),
        'quotient_translation': quotientSection(results, 'translation', (0.05, 0.1, 0.25, 0.5, 1.0)),
        'quotient_rotation': quotientSection(results, 'rotation', (0.1, 0.5, 1.0, 2.0, 3.14)),
        'within_translation': withinSection(results, 'translation'),
        'within_rotation': withinSection(results, 'rotation'),
    }
    sections['consistency'] = consistencySection(results)
    for source in ('intel', 'lab'):
        for guess in ('near', 'far', 'anywhere'):
            sections[f'{guess}_{source}'] = reliabilitySection(results, source, guess)
    return {name: text for name, text in sections.items() if text}
