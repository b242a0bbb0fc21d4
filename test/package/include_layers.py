#!/usr/bin/env python3
"""Who includes whom: the table of docs/architecture.md, as data."""
import re

from support.check import Case, run

# Module of the library -> modules that it may include, besides itself.
LIBRARY = {
    'geometry': set(),
    'sensing': {'geometry'},
    'motion': {'geometry'},
    'grid': {'geometry', 'sensing'},
    'matching': {'geometry', 'sensing', 'grid'},
    'graph': {'geometry'},
    'mapping': {'geometry', 'sensing', 'motion', 'grid'},
    'localization': {'geometry', 'sensing', 'motion', 'grid'},
    'slam': {'geometry', 'sensing', 'motion', 'grid', 'matching', 'graph', 'mapping',
             'localization'},
    'exploration': {'geometry', 'sensing', 'grid'},
    'landmarks': {'geometry', 'sensing', 'grid'},
    'navigation': {'geometry', 'sensing', 'motion', 'grid'},
    'simulation': {'geometry', 'sensing', 'motion', 'grid'},
    'evaluation': {'geometry', 'sensing', 'grid', 'graph'},
    'results': {'geometry', 'grid', 'graph', 'evaluation', 'io'},
    'io': {'geometry', 'sensing', 'grid', 'graph'},
}
LIBRARY['config'] = set(LIBRARY)

# Third-party library -> pattern of its headers, and the only modules that may include them.
CONFINED = {
    'PCL': (r'pcl/', {'matching'}),
    'OpenCV': (r'opencv2?/', {'evaluation', 'grid', 'landmarks'}),
    'libpng': (r'png\.h$', {'grid'}),
    'OMPL': (r'ompl/', {'navigation'}),
    'SuiteSparse': (r'(suitesparse/)?(cholmod|SuiteSparse|amd|umfpack)|Eigen/.*CholmodSupport',
                    {'graph'}),
}
ROS = re.compile(r'(ros|tf|tf2|tf2_\w+|rosbag|rosgraph_msgs|\w+_msgs|\w+_srvs|message_filters|'
                 r'diagnostic_updater|actionlib|dynamic_reconfigure|catkin)/')
GENERATED = re.compile(r'omega_slam/[A-Z]\w*\.h$')  # messages of this package lie there too
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
# What the tools, beside the whole library, may take from the nodes' side: bags need its log.
NODE_HEADERS_OF_TOOLS = {'nodes/common/bag_log.h'}


def moduleOf(header):
    match = re.match(r'omega_slam/(\w+)/', header)
    return match and match.group(1)


def libraryFaults(module, header):
    """Why a file of the library's `module` may not include `header`."""
    other = moduleOf(header)
    if other and other != module and other not in LIBRARY[module]:
        yield f'{module} may not include {other}'
    if ROS.match(header) or GENERATED.match(header):
        yield 'the library may not include ROS'
    if header.startswith(('nodes/', 'tools/')):
        yield 'the library may not include nodes or tools'
    for name, (pattern, modules) in CONFINED.items():
        if re.match(pattern, header) and module not in modules:
            yield f'only {" and ".join(sorted(modules))} may include {name}'


def toolFaults(header):
    if header.startswith('nodes/') and header not in NODE_HEADERS_OF_TOOLS:
        yield 'a tool may not include what belongs to the nodes'
    if ROS.match(header) or GENERATED.match(header):
        yield 'a tool may not include ROS'


def check(tree):
    for path in tree.files('src/**/*.h', 'src/**/*.cpp'):
        parts = tree.relative(path).parts
        if parts[1] == 'omega_slam' and parts[2] not in LIBRARY:
            yield f'{tree.relative(path)}: module "{parts[2]}" is not in the table of layers'
            continue
        for header in INCLUDE.findall(path.read_text()):
            if parts[1] == 'omega_slam':
                faults = libraryFaults(parts[2], header)
            elif parts[1] == 'tools':
                faults = toolFaults(header)
            else:
                faults = []
            for fault in faults:
                yield f'{tree.relative(path)} includes {header}: {fault}'


def oneFile(path, include):
    return {path: f'#pragma once\n#include {include}\n'}


CASES = [
    Case(oneFile('src/omega_slam/grid/a.h', '"omega_slam/geometry/pose2.h"')),
    Case(oneFile('src/omega_slam/config/a.h', '"omega_slam/slam/pipeline.h"')),
    Case(oneFile('src/nodes/common/a.h', '<sensor_msgs/LaserScan.h>')),
    Case(oneFile('src/tools/a.cpp', '"nodes/common/bag_log.h"')),
    Case(oneFile('src/omega_slam/geometry/a.h', '"omega_slam/grid/grid.h"'),
         ('geometry may not include grid',)),
    Case(oneFile('src/omega_slam/graph/a.h', '"omega_slam/sensing/sweep.h"'),
         ('graph may not include sensing',)),
    Case(oneFile('src/omega_slam/slam/a.h', '<sensor_msgs/LaserScan.h>'), ('ROS',)),
    Case(oneFile('src/omega_slam/slam/a.h', '"ros/ros.h"'), ('ROS',)),
    Case(oneFile('src/omega_slam/slam/a.h', '<tf2_ros/buffer.h>'), ('ROS',)),
    Case(oneFile('src/omega_slam/io/a.h', '<rosbag/bag.h>'), ('ROS',)),
    Case(oneFile('src/omega_slam/slam/a.h', '<omega_slam/Keyframe.h>'), ('ROS',)),
    Case(oneFile('src/omega_slam/slam/a.h', '"nodes/common/names.h"'), ('nodes',)),
    Case(oneFile('src/omega_slam/slam/a.cpp', '<pcl/point_types.h>'), ('PCL',)),
    Case(oneFile('src/omega_slam/slam/a.cpp', '<opencv2/core.hpp>'), ('OpenCV',)),
    Case(oneFile('src/omega_slam/slam/a.cpp', '<cholmod.h>'), ('SuiteSparse',)),
    Case(oneFile('src/omega_slam/kitchen/a.cpp', '<vector>'), ('kitchen',)),
    Case(oneFile('src/tools/a.cpp', '"nodes/common/names.h"'), ('nodes',)),
    Case(oneFile('src/tools/a.cpp', '<ros/ros.h>'), ('ROS',)),
]

if __name__ == '__main__':
    run(__doc__, check, CASES)
