"""The tables of docs/experiments/maps.md."""
from map_tables import ALIGNMENTS, RENDERERS, SITES, SOURCES, Scores, having, mean
from page import markdownTable, percent
from tables import column

PAPER = {'triangle': 0.9295, 'plain_triangle': 0.9295, 'beam': 0.9062}


def siteName(site):
    return SITES.get(site, site)


def runSection(results):
    """What the page is of, in a sentence."""
    if not results.has('run') or not results.rows('scores'):
        return None
    run = results.table('run')[0]
    seeds = len({row['seed'] for row in results.rows('scores')})
    return (f'This page: {seeds} drives through each building, on {run["date"]}, one of '
            f'{run["processors"]:.0f} processors "{run["processor"]}", {run["compiler"]}, '
            'RelWithDebInfo.\n')


def meanAndLeast(scores):
    if not scores.rows:
        return 'none'
    found = f'{percent(scores.mean(), 2)} ({percent(scores.least(), 2)})'
    missing = len(scores.all) - len(scores.rows)
    return f'{found}, {missing} without' if missing else found


def paperSection(results):
    """SLAM's maps, at each alignment, beside the paper's."""
    table = []
    for site in results.sites():
        for renderer in ('triangle', 'plain_triangle', 'beam'):
            rows = having(results.rows('scores'), site=site, renderer=renderer, source='slam')
            cells = [meanAndLeast(Scores(rows, alignment=name)) for name in ALIGNMENTS]
            paper = percent(PAPER[renderer], 2) if site == 'swarmlab' else '-'
            table.append([siteName(site), RENDERERS[renderer], *cells, paper])
    return table and markdownTable(
        ['building', 'renderer', 'resemblance, by SIFT', 'by correlation', 'by trajectory',
         'the paper, by SIFT'], table)


def ceilingSection(results):
    """What the measure leaves where poses are true, and where there is no noise."""
    table = []
    for site in results.sites():
        for renderer in ('triangle', 'beam'):
            for source, label in SOURCES.items():
                scores = Scores(results.rows('scores'), site=site, renderer=renderer, source=source,
                                alignment='trajectory')
                table.append([siteName(site), RENDERERS[renderer], label] + [
                    percent(scores.mean(key), 2) for key in (
                        'score', 'balanced', 'wall_precision', 'wall_recall', 'open_precision',
                        'open_recall', 'coverage')])
    return table and markdownTable(
        ['building', 'renderer', 'drawn from', 'resemblance', 'balanced', 'walls right',
         'walls found', 'open right', 'open found', 'seen'], table)


def drivesSection(results):
    table = []
    for site in results.sites():
        rows = having(results.rows('surveys'), site=site)
        if rows:
            table.append([siteName(site), f'{mean(column(rows, "metres")):.0f} m',
                          f'{mean(column(rows, "seconds")):.0f} s',
                          f'{mean(column(rows, "keyframes")):.0f}',
                          f'{mean(column(rows, "loops")):.0f}',
                          f'{100 * mean(column(rows, "mean_error")):.1f} cm',
                          f'{100 * max(column(rows, "max_error")):.1f} cm'])
    return table and markdownTable(
        ['building', 'driven', 'in', 'keyframes', 'loops', 'mean error of position',
         'worst error of all'], table)


def peerSection(results):
    """The same scans, drawn by others."""
    table = []
    for site in results.sites():
        for row in having(results.rows('peer'), site=site):
            table.append([siteName(site), RENDERERS[row['drawn_by']], f'{row["microseconds"]:.0f}',
                          percent(row['alike'], 2), percent(row['known_by_both'], 2),
                          percent(row['resemblance'], 2), percent(row['wall_precision'], 2),
                          percent(row['wall_recall'], 2)])
    return table and markdownTable(
        ['building', 'drawn by', 'microseconds a scan', 'cells alike', 'known by both',
         'resemblance', 'walls right', 'walls found'], table)


def milliseconds(microseconds):
    return f'{microseconds / 1000:.3g} ms'


def timesSection(results):
    """What it costs to keep a map in step, by its size."""
    times = {name: row['real_time'] for name, row in results.times().items()}
    table = []
    for count in (100, 1000, 5000):
        redraw = times.get(f'redraw/{count}')
        if redraw:
            one = times[f'add_keyframe/{count}']
            table.append([f'{count}', milliseconds(redraw), milliseconds(one), f'{redraw / one:.0f}',
                          milliseconds(times[f'show_keyframe/{count}'])] +
                         [f'{milliseconds(times[name])} ({percent(times[name] / redraw, 0)})'
                          for name in (f'move_tenth/{count}', f'move_all/{count}')])
    return table and markdownTable(
        ['keyframes', 'all drawn anew', 'one added', 'times less', 'its raster', 'a tenth moves',
         'all move'], table)


DRAWINGS = {'sweep/beam': 'a sweep by beams', 'sweep/triangle': 'a sweep by triangles',
            'sweep/triangle_join_all': "a sweep by triangles, the paper's plain rule",
            'fill/scan_line': 'its triangles filled row by row',
            'fill/cell_test': "its triangles filled by the paper's cell test",
            'scan_alone': 'a keyframe for a map of 200 m x 200 m',
            'scan_while_publishing': 'the same while that map is published once a second'}


def drawingSection(results):
    """What single pieces of drawing cost."""
    times = results.times()
    return times and markdownTable(
        ['what', 'microseconds'], [[text, f'{times[name]["real_time"]:.0f}']
                                   for name, text in DRAWINGS.items()])


def memorySection(results):
    """What a keyframe takes in a map of 5000."""
    times = results.times()
    if not times:
        return None
    kept, forgotten = (times[f'memory/{name}']['label'] for name in ('kept', 'forgotten'))
    return (f'In a map of 5000 keyframes, each takes {kept / 1024:.1f} KB beside its sweep where people are '
            f'kept, and {forgotten / 1024:.1f} KB where they are forgotten: tiles included.\n')


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {'run': runSection(results), 'paper': paperSection(results),
                'ceiling': ceilingSection(results), 'drives': drivesSection(results),
                'peer': peerSection(results), 'times': timesSection(results),
                'drawing': drawingSection(results), 'memory': memorySection(results)}
    return {name: text for name, text in sections.items() if text}
