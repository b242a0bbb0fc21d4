"""The figures of docs/experiments/slam.md."""
from figures import legendBelow, pyplot, save
from slam_tables import GOOD_ERROR

COLOURS = {'lab': '#0072B2', 'office': '#009E73', 'maze': '#E69F00', 'corridor': '#CC79A7'}
MARKERS = {'urg': 'o', 'sick': 's', 'rplidar': '^', 'lds': 'v', 'kinect': '<', 'utm': 'D'}


def drawSimulation(results, path):
    """Every drive: its error against that of its odometry."""
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    for (world, laser), rows in drivesByLaser(results).items():
        axes.scatter([row['odometry_error'] for row in rows], [row['error'] for row in rows], s=22,
                     color=COLOURS.get(world, '#555555'), marker=MARKERS.get(laser, 'x'),
                     label=f'{world}, {laser}', alpha=0.8)
    axes.axhline(GOOD_ERROR, color='#555555', linestyle=':')
    axes.set(xscale='log', yscale='log', xlabel='error of the odometry (m)',
             ylabel='error of the trajectory (m)')
    legendBelow(figure, axes)
    save(figure, path)


def drivesByLaser(results):
    groups = {}
    for (world, laser, _), rows in results.drives().items():
        groups.setdefault((world, laser), []).extend(rows)
    return groups


def drawGrowth(results, path):
    """Time of a scan and memory, against how often the log was driven."""
    rows = results.rows('growth')
    passes = [row['passes'] for row in rows]
    figure, (times, memory) = pyplot.subplots(1, 2, figsize=(10, 3.6))
    times.plot(passes, [row['mean_ms'] for row in rows], color='#0072B2', label='mean')
    times.plot(passes, [row['p99_ms'] for row in rows], color='#E69F00', label='99 % are below')
    times.set(xlabel='passes', ylabel='a scan (ms)', ylim=(0, None))
    times.legend()
    memory.plot(passes, [row['memory_mb'] for row in rows], color='#0072B2')
    memory.set(xlabel='passes', ylabel='memory (MB)', ylim=(0, None))
    save(figure, path)


def drawAll(results, folder):
    if results.has('growth'):
        drawGrowth(results, folder / 'growth.png')
    if results.has('simulation'):
        drawSimulation(results, folder / 'simulation.png')
