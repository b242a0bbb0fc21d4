"""The tables of docs/experiments/navigation.md."""
import statistics

from page import markdownTable, percent
from tables import column


def byKey(rows, key):
    """Value -> its rows, in the order of the table."""
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return groups


def quantile(values, share):
    """The least value that so large a share of all does not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def touches(row):
    return bool(row['found']) and row['least_clearance'] < row['radius'] - 1e-6


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run'):
        return None
    run = results.table('run')[0]
    return (f'This page: on {run["date"]}, one of {run["processors"]:.0f} processors '
            f'"{run["processor"]}", {run["compiler"]}, RelWithDebInfo.\n')


def planRow(name, rows):
    ways = [row for row in rows if row['has_way']]
    both = [row for row in ways if row['found']]
    longer = sum(column(both, 'length')) / sum(column(both, 'shortest')) if both else float('nan')
    times = column(rows, 'milliseconds')
    return [name, len(rows), len(ways), percent(len(both) / max(1, len(ways)), 2),
            sum(bool(row['found']) and not row['has_way'] for row in rows), f'{longer:.3f}',
            f'{statistics.median(times):.1f}', f'{quantile(times, 0.99):.1f}',
            sum(map(touches, rows))]


def plansSection(results, table, key):
    if not results.has(table):
        return None
    return markdownTable(
        [key, 'asked', 'oracle has a way', 'found', 'found without', 'length', 'median (ms)',
         'p99 (ms)', 'touched'],
        [planRow(name, rows) for name, rows in byKey(results.table(table), key).items()])


def goalRow(name, rows):
    possible = [row for row in rows if row['wanted'] == 'reached']
    reached = [row for row in possible if row['outcome'] == 'reached']
    refused = [row for row in rows if row['wanted'] != 'reached' and row['right']]
    wrong = len(rows) - len(possible) - len(refused)
    speed = sum(column(reached, 'driven')) / max(1e-9, sum(column(reached, 'seconds')))
    longer = sum(column(reached, 'driven')) / max(1e-9, sum(column(reached, 'planned')))
    return [name, len(rows), f'{len(reached)} of {len(possible)}', len(refused),
            len(possible) - len(reached), wrong, f'{sum(column(rows, "collisions")):.0f}',
            f'{min(column(rows, "nearest_person")):.2f} m', f'{speed:.2f} m/s', f'{longer:.2f}']


def goalsSection(results):
    if not results.has('goals'):
        return None
    return markdownTable(
        ['world', 'goals', 'reached', 'refused rightly', 'given up', 'refused wrongly', 'touched',
         'nearest person', 'speed', 'driven / planned'],
        [goalRow(name, rows) for name, rows in byKey(results.table('goals'), 'world').items()])


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {'run': runSection(results), 'queries': plansSection(results, 'queries', 'world'),
                'planners': plansSection(results, 'planners', 'planner'),
                'goals': goalsSection(results)}
    return {name: text for name, text in sections.items() if text}
