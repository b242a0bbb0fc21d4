"""The figures of docs/experiments/slam.md."""
from figures import legendBelow, pyplot, save
from slam_tables import GOOD_ERROR

COLOURS = {'lab': '#0072B2', 'office': '#009E73', 'maze': '#E69F00'}
MARKERS = {'urg': 'o', 'sick': 's', 'rplidar': '^', 'utm': 'D'}


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


def drawAll(results, folder):
    if results.has('simulation'):
        drawSimulation(results, folder / 'simulation.png')
