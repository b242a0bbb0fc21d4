"""How the programs of the peers are called, and how their rows get into the table."""
import argparse
import pathlib
import subprocess
import tempfile

from graph_file import writePoses
from measuring import peakMegabytes


class Solution:
    def __init__(self, poses, iterations, seconds, own_cost):
        self.poses = poses
        self.iterations = iterations
        self.seconds = seconds
        self.own_cost = own_cost  # twice what the solver minimises: without the factor 1/2


def argumentParser(purpose):
    parser = argparse.ArgumentParser(description=purpose.splitlines()[0])
    parser.add_argument('graph', type=pathlib.Path, help='g2o, with the first guess in it')
    parser.add_argument('--program', type=pathlib.Path, required=True, help='graph_experiments')
    parser.add_argument('--name', required=True, help='of the graph')
    return parser


def firstLine(error):
    return str(error).strip().split('\n')[0]


def printRow(arguments, guess, solver, solution):
    """Has graph_experiments score the poses, by the one cost that all are judged by.

    @param solution: None where the solver failed
    """
    with tempfile.TemporaryDirectory() as folder:
        command = [arguments.program, 'score', arguments.graph, '--name', arguments.name,
                   '--guess', guess, '--solver', solver, '--peak', str(peakMegabytes())]
        if solution is not None:
            solved = pathlib.Path(folder, 'solved.g2o')
            writePoses(solved, solution.poses)
            command += [solved, '--iterations', str(solution.iterations), '--milliseconds',
                        str(1e3 * solution.seconds), '--own-cost', str(solution.own_cost)]
        subprocess.run(command, check=True)
