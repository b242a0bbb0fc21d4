"""Graphs of SE(2) poses in g2o's format."""


class Graph:
    """Poses [(x, y, theta)] by id, and constraints (from, to, (x, y, theta), information)."""

    def __init__(self):
        self.poses = {}
        self.constraints = []


def symmetric(upper):
    """A 3 x 3 matrix from its upper triangle, row by row."""
    a, b, c, d, e, f = upper
    return [[a, b, c], [b, d, e], [c, e, f]]


def readGraph(path):
    graph = Graph()
    with open(path, encoding='utf-8') as stream:
        for line in stream:
            tag, *words = line.split()
            if tag == 'VERTEX_SE2':
                graph.poses[int(words[0])] = tuple(map(float, words[1:4]))
            elif tag == 'EDGE_SE2':
                values = tuple(map(float, words[2:]))
                graph.constraints.append((int(words[0]), int(words[1]), values[:3],
                                          symmetric(values[3:])))
            elif tag != 'FIX':
                raise ValueError(f'{path}: {tag} is not for the peers')
    return graph


def writePoses(path, poses):
    with open(path, 'w', encoding='utf-8') as stream:
        for name, pose in sorted(poses.items()):
            stream.write('VERTEX_SE2 {} {!r} {!r} {!r}\n'.format(name, *map(float, pose)))
