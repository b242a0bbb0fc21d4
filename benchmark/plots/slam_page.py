"""The tables of docs/experiments/slam.md."""
import statistics

from page import markdownTable, percent
from slam_tables import COSTS, GOALS, LOGS, PEERS, having, inOrder, isGood, isKnown, trueShare
from tables import column

PARTS = ('accuracy', 'throughput', 'growth', 'simulation', 'hostile')
FAULTS = {
    'none': 'none', 'duplicated_10': '10 % of the scans twice',
    'duplicated_30': '30 % of the scans twice', 'reordered_10': '10 % of the scans out of order',
    'reordered_30': '30 % of the scans out of order', 'missing_10': '10 % of the scans missing',
    'missing_30': '30 % of the scans missing', 'gap_1': 'three gaps of 1 s',
    'gap_10': 'three gaps of 10 s', 'gap_60': 'three gaps of 60 s',
    'frozen_laser': 'laser frozen, three times 10 s', 'half_blocked': 'half of the view blocked',
    'person': 'a person walks in front', 'kidnapped': 'carried along its way for 20 s',
    'odometry_reset': 'odometry back to zero',
    'odometry_scale': 'odometry overstates ways by 5 %',
    'turn_scale': 'odometry understates turns by 10 %',
    'laser_askew': 'laser 0.05 rad askew'}


def metres(value, digits=3):
    return f'{value:.{digits}f}' if isKnown(value) else '-'


def share(value):
    return '-' if value is None or not isKnown(value) else percent(value)


def runSection(results, part):
    """When and where a part was run, in a sentence."""
    if not results.has(f'run_{part}'):
        return None
    run, = results.table(f'run_{part}')
    return (f'On {run["date"]}, one of {run["processors"]:.0f} processors "{run["processor"]}", '
            f'{run["compiler"]}, RelWithDebInfo.\n')


def againstPeers(results):
    """Our error on a log beside that of others."""
    rows = having(results.rows('accuracy'))
    logs = [log for log in PEERS if having(rows, log=log)]
    table = []
    for peer in PEERS['intel_first']:
        cells = [peer]
        for log in logs:
            figures = PEERS[log][peer]
            cells += ['fails', 'fails'] if figures is None else [f'{figures[0]:.4f}',
                                                                 f'{figures[1]:.2f}']
        table.append(cells)
    ours, goals = ['**omega_slam**'], ['to be reached']
    for log in logs:
        row, = having(rows, log=log)
        ours += [f'**{row["error"]:.4f}**', f'**{row["turn"]:.2f}**']
        goals += [f'{GOALS[log][0]:.4f}', f'{GOALS[log][1]:.2f}']
    head = ['']
    for log in logs:
        head += [f'{LOGS[log]}: m', 'degrees']
    return logs and markdownTable(head, table + [ours, goals])


def accuracySection(results):
    table = []
    for row in inOrder(results.rows('accuracy'), 'log', LOGS):
        deviation = f' ± {row["error_deviation"]:.4f}' if isKnown(row['error']) else ''
        turned = f' ± {row["turn_deviation"]:.2f}' if isKnown(row['turn']) else ''
        table.append([
            LOGS.get(row['log'], row['log']), f'{row["scans"]:.0f}', f'{row["keyframes"]:.0f}',
            share(row['covered']), metres(row['error'], 4) + deviation, metres(row['worst']),
            metres(row['turn'], 2) + turned, metres(row['odometry_error'], 2),
            f'{row["loops"]:.0f}', share(trueShare(row)), f'{row["withdrawn"]:.0f}'])
    return table and markdownTable(
        ['log', 'scans', 'keyframes', 'relations covered', 'error (m)', 'worst (m)',
         'turned (degrees)', 'odometry alone (m)', 'loops found', 'of them true', 'withdrawn'],
        table)


def wallsSection(results):
    """How crisp walls are, ours beside gmapping's."""
    table = []
    rows = results.rows('walls')
    for row in inOrder(having(rows, who='omega_slam'), 'log', LOGS):
        other = having(rows, log=row['log'], who='gmapping')
        theirs = [f'{1e3 * other[0]["wall_distance"]:.1f}', f'{other[0]["entropy"]:.2f}'] if other \
            else ['-', '-']
        table.append([LOGS[row['log']], f'{row["scans"]:.0f}', f'{1e3 * row["wall_distance"]:.1f}',
                      theirs[0], f'{row["entropy"]:.2f}', theirs[1]])
    return table and markdownTable(
        ['log', 'scans', 'distance to walls (mm)', 'gmapping', 'entropy', 'gmapping'], table)


def throughputSection(results):
    table = []
    ratios = {row['log']: row for row in results.rows('ratio')}
    for row in inOrder(results.rows('throughput'), 'log', LOGS):
        ratio = ratios.get(row['log'])
        table.append([LOGS[row['log']], f'{row["scans"]:.0f}', f'{row["rounds"]:.0f}',
                      f'{row["cpu_seconds"]:.2f}',
                      *(f'{seconds:g}' for seconds in COSTS[row['log']].values()),
                      f'{row["median_ms"]:.3f}', f'{row["p99_ms"]:.1f}', f'{row["max_ms"]:.1f}',
                      f'{row["peak_mb"]:.0f}', f'{ratio["ratio"]:.2f}' if ratio else '-'])
    peers = list(COSTS['intel_first'])
    return table and markdownTable(
        ['log', 'scans', 'rounds', 'omega_slam (CPU s)', *peers, 'a scan: median (ms)', '99 %', 'most',
         'memory (MB)', 'a scan / a match by ICP'], table)


def growthSection(results):
    rows = results.rows('growth')
    table = []
    for tenth in range(1, 11):
        upto = [row for row in rows if row['passes'] <= tenth + 0.01]
        here = [row for row in upto if row['passes'] > tenth - 1 + 0.01]
        if not here:
            continue
        last = upto[-1]
        table.append([f'{tenth}', f'{last["scans"]:.0f}', f'{last["keyframes"]:.0f}',
                      f'{last["constraints"]:.0f}',
                      f'{statistics.mean(column(here, "mean_ms")):.2f}',
                      f'{max(column(here, "p99_ms")):.1f}', f'{max(column(here, "max_ms")):.1f}',
                      f'{last["memory_mb"]:.0f}'])
    return table and markdownTable(
        ['pass', 'scans so far', 'keyframes', 'constraints', 'a scan: mean (ms)', '99 %', 'most',
         'memory (MB)'], table) + '\n![Time of a scan and memory against passes](slam/growth.png)\n'


def simulationSection(results):
    table = []
    for (world, laser, noise), rows in results.drives().items():
        table.append([
            world, laser, f'{noise:g}', f'{sum(map(isGood, rows))} of {len(rows)}',
            metres(statistics.median(column(rows, 'error'))), metres(max(column(rows, 'error'))),
            metres(statistics.median(column(rows, 'turn')), 2),
            metres(statistics.median(column(rows, 'odometry_error')), 2),
            metres(max(column(rows, 'odometry_error')), 1),
            f'{sum(column(rows, "loops")):.0f}', f'{sum(column(rows, "false_loops")):.0f}',
            f'{statistics.median(column(rows, "squared_length")):.2g}'])
    return table and markdownTable(
        ['world', 'laser', 'noise', 'good runs', 'median error (m)', 'worst error (m)',
         'turned (degrees)', 'odometry: median error (m)', 'worst (m)', 'loops', 'false ones',
         'squared error / covariance'], table)


def corridorSection(results):
    """Whether the graph knows how far along the corridor it may be off."""
    table = []
    for (world, _, noise), rows in results.drives().items():
        if world == 'corridor':
            worst = max(rows, key=lambda row: row['worst_along'])
            table.append([f'{noise:g}', f'{len(rows)}', f'{sum(column(rows, "false_loops")):.0f}',
                          metres(worst['worst_along']), metres(worst['deviation_there']),
                          share(min(column(rows, 'within')))])
    return table and markdownTable(
        ['noise', 'runs', 'false loops', 'worst error along (m)', 'deviation stated there (m)',
         'keyframes within three deviations, at least'], table)


def hostileSection(results):
    table = []
    rows = results.rows('hostile')
    for log in dict.fromkeys(column(rows, 'log')):
        whole, = having(rows, log=log, fault='none')
        for row in having(rows, log=log):
            table.append([
                LOGS.get(log, log + ', simulated'), FAULTS[row['fault']], f'{row["scans"]:.0f}',
                f'{row["rejected"]:.0f}', share(row['covered']), metres(row['error'], 4),
                f'{row["error"] / whole["error"]:.1f}', metres(row['turn'], 2),
                metres(row['worst']), f'{row["loops"]:.0f}', f'{row["withdrawn"]:.0f}'])
    return table and markdownTable(
        ['run', 'fault', 'scans', 'rejected', 'covered', 'error (m)', 'times that of none',
         'turned (degrees)', 'worst (m)', 'loops', 'withdrawn'], table)


def sectionsOf(results):
    """Name in the page -> table."""
    sections = {f'run_{part}': runSection(results, part) for part in PARTS}
    sections.update(peers=againstPeers(results), accuracy=accuracySection(results),
                    walls=wallsSection(results), throughput=throughputSection(results),
                    growth=growthSection(results), corridor=corridorSection(results),
                    simulation=simulationSection(results), hostile=hostileSection(results))
    return {name: text for name, text in sections.items() if text}
