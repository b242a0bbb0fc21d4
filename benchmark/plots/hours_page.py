"""The tables of docs/experiments/graph_hours.md."""
from page import markdownTable

HEADS = ['hour', 'keyframes', 'estimated', 'constraints', 'an update: mean (ms)', 'median', '99 %',
         'most', 'memory (MB)', 'error from the start (m)', 'as stated (m)',
         'error from 500 keyframes before (m)']


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run') or not results.has('thinned'):
        return None
    run = results.table('run')[0]
    return (f'This page: on {run["date"]}, one of {run["processors"]:.0f} processors '
            f'"{run["processor"]}", {run["compiler"]}, RelWithDebInfo.\n')


def rowsOf(table):
    return [[hour, f'{row["keyframes"]:.0f}', f'{row["estimated"]:.0f}',
             f'{row["constraints"]:.0f}', f'{row["mean_ms"]:.1f}', f'{row["median_ms"]:.1f}',
             f'{row["p99_ms"]:.0f}', f'{row["max_ms"]:.0f}', f'{row["memory_mb"]:.0f}',
             f'{row["error_m"]:.2f}', f'{row["stated_m"]:.2f}', f'{row["relative_error_m"]:.3f}']
            for hour, row in enumerate(table, start=1)]


def driveSection(results, name):
    return results.has(name) and markdownTable(HEADS, rowsOf(results.table(name)))


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {'run': runSection(results), 'thinned': driveSection(results, 'thinned'),
                'kept': driveSection(results, 'kept')}
    return {name: text for name, text in sections.items() if text}
