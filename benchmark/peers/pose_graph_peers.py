#!/usr/bin/env python3
"""Solves a graph by GTSAM or g2o, from the poses in its file, and prints a row of the table.

The poses are scored by graph_experiments, which knows the one cost that all are judged by.
"""
import concurrent.futures
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from graph_file import readGraph  # noqa: E402  (the path comes first)
from measuring import medianSeconds  # noqa: E402
from scoring import Solution, argumentParser, firstLine, printRow  # noqa: E402

RELATIVE_GAIN = 1e-6  # as in benchmark/graph/contestants.h
MAX_ITERATIONS = 100


def solveByGtsam(graph, repetitions, method):
    import gtsam
    from gtsam_graph import posesOf, toFactors, toValues
    parameters = getattr(gtsam, method + 'Params')()
    parameters.setMaxIterations(MAX_ITERATIONS)
    parameters.setRelativeErrorTol(RELATIVE_GAIN)
    parameters.setAbsoluteErrorTol(0.0)
    parameters.setErrorTol(0.0)
    optimizer_of = getattr(gtsam, method + 'Optimizer')
    factors = toFactors(graph)
    guess = toValues(graph.poses)

    def solve(values):
        optimizer = optimizer_of(factors, values, parameters)  # finds an ordering
        return optimizer, optimizer.optimize()
    seconds, (optimizer, values) = medianSeconds(lambda: guess, solve, repetitions)
    return Solution(posesOf(values), optimizer.iterations(), seconds, 2.0 * factors.error(values))


def toOptimizer(graph):
    import g2o
    import numpy
    optimizer = g2o.SparseOptimizer()
    optimizer.set_algorithm(g2o.OptimizationAlgorithmGaussNewton(
        g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())))
    for name, pose in graph.poses.items():
        vertex = g2o.VertexSE2()
        vertex.set_id(name)
        vertex.set_estimate(g2o.SE2(*pose))
        vertex.set_fixed(name == min(graph.poses))
        optimizer.add_vertex(vertex)
    for tail, head, measured, information in graph.constraints:
        edge = g2o.EdgeSE2()
        edge.set_vertex(0, optimizer.vertex(tail))
        edge.set_vertex(1, optimizer.vertex(head))
        edge.set_measurement(g2o.SE2(*measured))
        edge.set_information(numpy.array(information))
        optimizer.add_edge(edge)
    optimizer.initialize_optimization()
    return optimizer


def iterationsOfG2o(graph):
    """How many it takes until one gains less than RELATIVE_GAIN."""
    import g2o
    optimizer = toOptimizer(graph)
    stop = g2o.SparseOptimizerTerminateAction()
    stop.set_gain_threshold(RELATIVE_GAIN)
    stop.set_max_iterations(MAX_ITERATIONS)
    optimizer.add_post_iteration_action(stop)
    return optimizer.optimize(MAX_ITERATIONS)


def solveByG2o(graph, repetitions):
    # The action that stops g2o computes all errors once more, so it is not there when time counts;
    # nor is its memory, that of another process.
    with concurrent.futures.ProcessPoolExecutor(1) as other_process:
        iterations = other_process.submit(iterationsOfG2o, graph).result()
    if iterations == 0:
        raise RuntimeError('g2o could not factorise')
    optimizer = toOptimizer(graph)
    optimizer.push()

    def backToGuess():
        optimizer.pop()
        optimizer.push()
    seconds, _ = medianSeconds(backToGuess, lambda _: optimizer.optimize(iterations), repetitions)
    optimizer.compute_active_errors()
    poses = {name: optimizer.vertex(name).estimate().to_vector() for name in graph.poses}
    return Solution(poses, iterations, seconds, optimizer.active_chi2())


SOLVERS = {
    'gtsam_gn': lambda graph, repetitions: solveByGtsam(graph, repetitions, 'GaussNewton'),
    'gtsam_lm': lambda graph, repetitions: solveByGtsam(graph, repetitions, 'LevenbergMarquardt'),
    'g2o_gn': solveByG2o,
}


def main():
    parser = argumentParser(__doc__)
    parser.add_argument('--solver', choices=SOLVERS, required=True)
    parser.add_argument('--guess', required=True, help='what the first guess is called')
    parser.add_argument('--repetitions', type=int, default=5)
    arguments = parser.parse_args()
    try:
        solution = SOLVERS[arguments.solver](readGraph(arguments.graph), arguments.repetitions)
    except RuntimeError as error:  # a system that it can't factorise
        print(f'{arguments.solver} fails on {arguments.name}: {firstLine(error)}', file=sys.stderr)
        solution = None
    printRow(arguments, arguments.guess, arguments.solver, solution)


if __name__ == '__main__':
    main()
