"""Finds the way between places to visit, with room for a robot on both sides."""
import heapq
import math

import numpy as np

from .plan import FREE, RESOLUTION

STRIDE = 2              # [pixels] between the nodes of the search
MIN_CLEARANCE = 0.27    # [m] from the robot's centre to any obstacle: its radius and a hand's width
COMFORTABLE = 0.60      # [m] more room than this is worth no detour
SHORTCUT_SHARE = 0.90   # a straight line may come so much closer to obstacles than the path,
SHORTCUT_ROOM = 0.42    # [m] and where there is so much room, it is straight anyway


def plan_route(plan, start, stops):
    """Waypoints [m] that lead from `start` past every stop in turn."""
    room = clearance(plan.grey != FREE)
    route = []
    here = start
    for stop in stops:
        path = simplify(room, search(room, here, stop))
        route += path[1:]
        here = stop
    return route


def clearance(obstacle):
    """Distance [m] of every pixel's centre to the nearest obstacle, capped at COMFORTABLE."""
    reach = int(math.ceil(COMFORTABLE / RESOLUTION)) + 1
    distance = np.full(obstacle.shape, COMFORTABLE)
    padded = np.pad(obstacle, reach, constant_values=True)
    height, width = obstacle.shape
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            # To the nearest edge of that pixel, not to its centre.
            gap = math.hypot(max(abs(dx) - 0.5, 0), max(abs(dy) - 0.5, 0)) * RESOLUTION
            if gap < COMFORTABLE:
                shifted = padded[reach + dy:reach + dy + height, reach + dx:reach + dx + width]
                distance[shifted & (distance > gap)] = gap
    return distance


def search(room, start, goal):
    """A* over every second pixel; narrow places cost more. @return points [m]"""
    nodes = room[::STRIDE, ::STRIDE]
    step_m = STRIDE * RESOLUTION
    source, target = node_of(start), node_of(goal)
    for name, node in (('start', source), ('stop', target)):
        if nodes[node] < MIN_CLEARANCE:
            raise ValueError(f'{name} {start if name == "start" else goal} is too near to something')
    cost_to, parent, queue = {source: 0.0}, {}, [(0.0, source)]
    while queue:
        _, node = heapq.heappop(queue)
        if node == target:
            return trace(parent, start, goal, target)
        for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            near = (node[0] + dy, node[1] + dx)
            if not (0 <= near[0] < nodes.shape[0] and 0 <= near[1] < nodes.shape[1]):
                continue
            free = nodes[near]
            if free < MIN_CLEARANCE:
                continue
            cost = cost_to[node] + step_m * math.hypot(dx, dy) * (1 + 6 * (COMFORTABLE - free))
            if cost < cost_to.get(near, math.inf):
                cost_to[near], parent[near] = cost, node
                rest = step_m * math.hypot(near[0] - target[0], near[1] - target[1])
                heapq.heappush(queue, (cost + rest, near))
    raise ValueError(f'there is no way from {start} to {goal}')


def node_of(point):
    return (int(point[1] / RESOLUTION) // STRIDE, int(point[0] / RESOLUTION) // STRIDE)


def trace(parent, start, goal, node):
    inner = []
    while node in parent:
        inner.append(tuple((index * STRIDE + 0.5) * RESOLUTION for index in reversed(node)))
        node = parent[node]
    return [tuple(start), *reversed(inner[1:]), tuple(goal)]


def simplify(room, path):
    """Keeps as few points as straight lines with nearly the same clearance allow."""
    kept = [path[0]]
    index = 0
    while index < len(path) - 1:
        far = len(path) - 1
        while far > index + 1 and not is_straight(room, path[index:far + 1]):
            far -= 1
        kept.append(path[far])
        index = far
    return kept


def is_straight(room, piece):
    narrowest = min(at(room, point) for point in piece)
    needed = max(MIN_CLEARANCE, min(SHORTCUT_ROOM, SHORTCUT_SHARE * narrowest))
    (x0, y0), (x1, y1) = piece[0], piece[-1]
    steps = max(2, int(math.hypot(x1 - x0, y1 - y0) / (0.5 * RESOLUTION)))
    return all(at(room, (x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps)) >= needed - 1e-9
               for i in range(1, steps))


def at(room, point):
    return room[int(point[1] / RESOLUTION), int(point[0] / RESOLUTION)]
