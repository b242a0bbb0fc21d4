"""A corridor that is the same everywhere, but for its doors."""
from .plan import WALL, WALL_THICKNESS, Plan

DESCRIPTION = 'A bare corridor of 80 x 2 m with a closed door every 10 m: hard to tell how far one is.'

LENGTH, WIDTH = 80.0, 2.0
FIRST_DOOR, DOOR_EVERY = 5.0, 10.0
MIDDLE = WALL_THICKNESS + WIDTH / 2


def draw():
    t = WALL_THICKNESS
    plan = Plan(LENGTH + 2 * t, WIDTH + 3 * t)
    plan.room(t, t, t + LENGTH, t + WIDTH)
    plan.fill(0, WIDTH + 2 * t, LENGTH + 2 * t, WIDTH + 3 * t, WALL)  # closes the doors
    doors = int((LENGTH - FIRST_DOOR) / DOOR_EVERY) + 1
    for number in range(doors):
        plan.door(t + FIRST_DOOR + DOOR_EVERY * number, 1.5 * t + WIDTH)
    return plan, (t + 1.0, MIDDLE, 0.0), [(t + LENGTH - 1.0, MIDDLE), (t + 1.0, MIDDLE)]
