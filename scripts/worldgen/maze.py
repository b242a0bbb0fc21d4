"""A maze with a few loops, from a seeded depth-first walk."""
import random

from .plan import DARK, FREE, GLASS, WALL, Plan

DESCRIPTION = 'A maze of 10 x 10 m with passages of 1.25 m and some loops.'

CELLS = 7
PITCH = 1.4
BORDER = 0.1      # [m] outer wall; inner walls are as thick
SEED = 5
LOOPS = 6         # walls taken out so that ways close


def draw():
    generator = random.Random(SEED)
    open_sides = carve(generator)
    add_loops(generator, open_sides)
    plan = Plan(10.0, 10.0)
    plan.fill(0, 0, 10, 10, FREE)
    draw_walls(plan, open_sides)
    furnish(plan, generator, open_sides)
    start = center((0, 0))
    return plan, (*start, 0.0), tour(open_sides)


def center(cell):
    return tuple(BORDER + PITCH * index + PITCH / 2 - BORDER / 2 + 0.025 for index in cell)


def neighbours(cell):
    for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        near = (cell[0] + dx, cell[1] + dy)
        if all(0 <= index < CELLS for index in near):
            yield near


def pick(generator, items):
    """random() is the one draw whose sequence Python promises never to change."""
    return items[int(generator.random() * len(items))]


def side(a, b):
    return (min(a, b), max(a, b))


def carve(generator):
    """Every cell is reached, by one way only."""
    stack, seen, open_sides = [(0, 0)], {(0, 0)}, set()
    while stack:
        fresh = [near for near in neighbours(stack[-1]) if near not in seen]
        if not fresh:
            stack.pop()
            continue
        chosen = pick(generator, fresh)
        open_sides.add(side(stack[-1], chosen))
        seen.add(chosen)
        stack.append(chosen)
    return open_sides


def closed_sides(open_sides):
    cells = [(x, y) for x in range(CELLS) for y in range(CELLS)]
    return sorted({side(a, b) for a in cells for b in neighbours(a)} - open_sides)


def add_loops(generator, open_sides):
    for _ in range(LOOPS):
        open_sides.add(pick(generator, closed_sides(open_sides)))


def draw_walls(plan, open_sides):
    edge = BORDER + CELLS * PITCH
    for rectangle in ((0, 0, 10, BORDER), (0, edge - 0.001, 10, 10), (0, 0, BORDER, 10),
                      (edge - 0.001, 0, 10, 10)):
        plan.fill(*rectangle, WALL)
    for (x0, y0), (x1, _) in closed_sides(open_sides):
        left, low = PITCH * x0, PITCH * y0
        if x1 > x0:
            plan.fill(left + PITCH, low, left + PITCH + BORDER, low + PITCH + BORDER, WALL)
        else:
            plan.fill(left, low + PITCH, left + PITCH + BORDER, low + PITCH + BORDER, WALL)


def furnish(plan, generator, open_sides):
    """Buttresses, dark panels and a window, so that not every corner looks like every other."""
    walls = closed_sides(open_sides)
    for index in range(14):
        (x0, y0), (x1, _) = pick(generator, walls)
        along = 0.2 + 0.05 * int(generator.random() * 16)
        left, low = PITCH * x0, PITCH * y0
        grey = (WALL, WALL, DARK)[index % 3]
        if x1 > x0:
            plan.fill(left + PITCH - 0.1, low + along, left + PITCH + 0.2, low + along + 0.2, grey)
        else:
            plan.fill(left + along, low + PITCH - 0.1, left + along + 0.2, low + PITCH + 0.2, grey)
    (x0, y0), (x1, _) = walls[len(walls) // 2]
    if x1 > x0:
        plan.fill(PITCH * x1, PITCH * y0 + 0.4, PITCH * x1 + BORDER, PITCH * y0 + 1.0, GLASS)
    else:
        plan.fill(PITCH * x0 + 0.4, PITCH * (y0 + 1), PITCH * x0 + 1.0, PITCH * (y0 + 1) + BORDER,
                  GLASS)


def tour(open_sides):
    """To the nearest cell not yet seen, again and again, and home."""
    here, unseen, stops = (0, 0), {(x, y) for x in range(CELLS) for y in range(CELLS)}, []
    unseen.discard(here)
    while unseen:
        path = way(open_sides, here, unseen)
        unseen -= set(path)
        stops += [center(cell) for cell in path]
        here = path[-1]
    return stops + [center(cell) for cell in way(open_sides, here, {(0, 0)})]


def way(open_sides, here, goals):
    """The shortest way from a cell to the nearest of some others, without its first cell."""
    queue, came_from = [here], {here: None}
    for cell in queue:
        if cell in goals:
            path = []
            while came_from[cell] is not None:
                path.append(cell)
                cell = came_from[cell]
            return path[::-1]
        for near in neighbours(cell):
            if near not in came_from and side(cell, near) in open_sides:
                came_from[near] = cell
                queue.append(near)
    raise ValueError('the maze has a closed part')
