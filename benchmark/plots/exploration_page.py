"""The tables of docs/experiments/exploration.md."""
from exploration_tables import STRATEGIES, isDone, meanOf, strategiesOf
from page import markdownTable, percent

COVERED = 0.99     # of what can be seen
AT_HOME = 0.5      # [m]
PAPER = {'nearest_to_robot': 680.0, 'nearest_to_origin': 1400.0}  # [s]


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run') or not results.worlds():
        return None
    run = results.table('run')[0]
    rows = results.runs()
    return (f'This page: {len(rows)} runs, on {run["date"]}, on a busy machine with '
            f'{run["processors"]:.0f} processors "{run["processor"]}", {run["compiler"]}, '
            'RelWithDebInfo.\n')


def isComplete(row):
    """Whether a run has seen all and come home: others are short for other reasons."""
    return isDone(row) and row['coverage'] >= COVERED and row['from_home'] <= AT_HOME


def boundOf(results, world):
    """[m] Least length of a way that sees all; None if unknown, or nothing."""
    has_bound = results.has('bound', world)
    return results.table('bound', world)[0]['length'] or None if has_bound else None


def ratioTo(nearest, rows):
    """Of the mean times, over the seeds that both have."""
    seeds = {row['seed'] for row in nearest} & {row['seed'] for row in rows}
    if not seeds:
        return None
    times = [meanOf([row for row in group if row['seed'] in seeds], 'time')
             for group in (rows, nearest)]
    return times[0] / times[1]


def explored(rows, key):
    """Mean up to when nothing was left to see; a run that was cut off has no such time."""
    return f'{meanOf(rows, key):.0f}' if all(row['explored_time'] > 0.0 for row in rows) else '-'


def boundsSection(results):
    table = []
    for world in results.worlds():
        if (bound := boundOf(results, world)) is not None:
            places = results.table('bound', world)[0]['witnesses']
            complete = filter(isComplete, results.runs(world))
            shortest = min(complete, key=lambda row: row['distance'], default=None)
            if shortest is None:
                continue
            table.append([world, f'{bound:.0f}', f'{places:.0f}', f'{shortest["distance"]:.0f}',
                          f'{shortest["distance"] / bound:.1f}'])
    return table and markdownTable(
        ['world', 'bound (m)', 'places', 'shortest whole run (m)', 'to bound'], table)


def strategiesSection(results):
    table = []
    for world in results.worlds():
        bound = boundOf(results, world)
        for strategy in strategiesOf(results.runs(world)):
            rows = results.runs(world, strategy)
            ratio = ratioTo(results.runs(world, 'nearest_to_robot'), rows)
            table.append([
                world, STRATEGIES[strategy][0], len(rows), explored(rows, 'explored_time'),
                explored(rows, 'explored_distance'), f'{meanOf(rows, "time"):.0f}',
                f'{meanOf(rows, "distance"):.0f}', percent(meanOf(rows, 'coverage'), 2),
                '-' if ratio is None else f'{ratio:.2f}',
                '-' if bound is None else f'{meanOf(rows, "distance") / bound:.1f}',
                f'{PAPER[strategy]:.0f}' if world == 'swarmlab' and strategy in PAPER else ''])
    return table and markdownTable(
        ['world', 'strategy', 'runs', 'explored (s)', 'explored (m)', 'home again (s)',
         'home again (m)', 'coverage', 'time to nearest to robot', 'way to bound',
         'paper (s)'], table)


def robustnessSection(results):
    table = []
    for world in results.worlds():
        rows = results.runs(world)
        table.append([
            world, len(rows), sum(map(isDone, rows)),
            sum(row['coverage'] >= COVERED for row in rows),
            percent(min(row['coverage'] for row in rows), 2),
            sum(row['from_home'] <= AT_HOME for row in rows),
            sum(row['collisions'] == 0 for row in rows),
            sum(int(row['collisions']) for row in rows),
            sum(int(row['unseen']) for row in rows)])
    return table and markdownTable(
        ['world', 'runs', 'done', 'coverage >= 99 %', 'least coverage', 'home within 0.5 m',
         'without a collision', 'collisions in all', 'of these unseen'], table)


def timesSection(results):
    """Where the time goes; tables of older runs do not say it."""
    table = []
    for world in results.worlds():
        for strategy in strategiesOf(results.runs(world)):
            rows = results.runs(world, strategy)
            if 'driving' not in rows[0]:
                continue
            time = meanOf(rows, 'time')
            table.append([world, STRATEGIES[strategy][0],
                          f'{meanOf(rows, "distance") / time:.2f}']
                         + [percent(meanOf(rows, key) / time, 1)
                            for key in ('driving', 'turning', 'recovering', 'standing')])
    return table and markdownTable(
        ['world', 'strategy', 'mean speed (m/s)', 'driving', 'turning on the spot',
         'out of trouble', 'standing'], table)


def processorSection(results):
    table = []
    for world in results.worlds():
        rows = results.runs(world)
        time = sum(row['time'] for row in rows)
        shares = [sum(row[key] for row in rows) / time for key in ('explorer_cpu', 'navigator_cpu')]
        table.append([world, percent(shares[0], 2), percent(shares[1], 2), percent(sum(shares), 2)])
    return table and markdownTable(
        ['world', 'explorer', 'navigator', 'both, of a core at real time'], table)


def detectorsSection(results):
    if not results.has('detectors'):
        return None
    table = [[f'{row["size"]:.0f} x {row["size"]:.0f}', f'{row["wavefront"]:.2f}',
              f'{row["everything"]:.2f}', f'{row["fast"]:.3f}']
             for row in results.table('detectors')]
    return markdownTable(['cells', 'wavefront (ms)', 'everything (ms)', 'fast, a sweep (ms)'], table)


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {'run': runSection(results), 'strategies': strategiesSection(results),
                'bounds': boundsSection(results), 'times': timesSection(results),
                'robustness': robustnessSection(results), 'processor': processorSection(results),
                'detectors': detectorsSection(results)}
    return {name: text for name, text in sections.items() if text}
