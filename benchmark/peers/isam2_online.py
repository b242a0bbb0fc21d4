#!/usr/bin/env python3
"""Plays a graph pose by pose to GTSAM's iSAM2; prints a row, writes each update's time.

A pose comes with all constraints to poses before it, its guess by the constraint from the one just
before. Only the time of update() counts, not that of reading the last pose out.
"""
import pathlib
import sys

import gtsam

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from graph_file import readGraph  # noqa: E402  (the path comes first)
from gtsam_graph import anchor, posesOf, toFactor, toPose  # noqa: E402
from measuring import cpuSeconds  # noqa: E402
from scoring import Solution, argumentParser, firstLine, printRow  # noqa: E402

RELINEARIZE_THRESHOLD = 0.1


def constraintsByLastPose(graph):
    found = {name: [] for name in graph.poses}
    for constraint in graph.constraints:
        found[max(constraint[:2])].append(constraint)
    return found


def guess(isam, constraints, name):
    """The new pose, seen from the one just before, or from any other where there is no such tie."""
    tail, head, measured, _ = max(constraints, key=lambda constraint: min(constraint[:2]))
    measured = toPose(measured)
    if head == name:
        return isam.calculateEstimatePose2(tail).compose(measured)
    return isam.calculateEstimatePose2(head).compose(measured.inverse())


def play(graph, factorization):
    """(seconds of each update, solution)"""
    parameters = gtsam.ISAM2Params()
    parameters.setRelinearizeThreshold(RELINEARIZE_THRESHOLD)
    parameters.relinearizeSkip = 1
    parameters.setFactorization(factorization)
    isam = gtsam.ISAM2(parameters)
    times = []
    arriving = constraintsByLastPose(graph)
    for name in sorted(graph.poses):
        factors = gtsam.NonlinearFactorGraph()
        values = gtsam.Values()
        if times:
            values.insert(name, guess(isam, arriving[name], name))
        else:
            factors.add(anchor(name, graph.poses[name]))
            values.insert(name, toPose(graph.poses[name]))
        for constraint in arriving[name]:
            factors.add(toFactor(constraint))
        times.append(cpuSeconds(lambda: isam.update(factors, values))[0])
    final = isam.calculateBestEstimate()
    own_cost = 2.0 * isam.getFactorsUnsafe().error(final)
    return times, Solution(posesOf(final), len(times), sum(times), own_cost)


def playAnyhow(graph):
    """By Cholesky, which is faster; where that fails for rounding, by QR."""
    try:
        return play(graph, 'CHOLESKY')
    except RuntimeError as error:
        print(f'By QR, for Cholesky fails: {firstLine(error)}', file=sys.stderr)
        return play(graph, 'QR')


def main():
    parser = argumentParser(__doc__)
    parser.add_argument('--times', type=pathlib.Path, required=True,
                        help='to write: pose, microseconds')
    arguments = parser.parse_args()
    times, solution = playAnyhow(readGraph(arguments.graph))
    with open(arguments.times, 'w', encoding='ascii') as stream:
        stream.write('pose,microseconds\n')
        for pose, seconds in enumerate(times):
            stream.write(f'{pose},{1e6 * seconds:.1f}\n')
    printRow(arguments, 'online', 'isam2', solution)


if __name__ == '__main__':
    main()
