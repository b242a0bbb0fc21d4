"""An office floor: two corridors along, three across, rooms on all sides of them."""
from .plan import DARK, FREE, Plan

DESCRIPTION = ('An office floor of 40 x 25 m: corridors that close two loops, 22 rooms with '
               'furniture, glass fronts.')

SOUTH_WALLS = (0.0, 7.05, 13.35, 19.90, 26.40, 32.85, 39.85)   # [m] right ends of the rooms
NORTH_WALLS = (0.0, 6.00, 12.90, 20.40, 27.00, 33.40, 39.85)
SOUTH_DOORS = (4.2, 11.4, 15.2, 24.0, 28.6, 36.6)
NORTH_DOORS = (2.4, 10.6, 16.8, 22.6, 31.2, 37.4)


def draw():
    plan = Plan(40.0, 25.0)
    rooms(plan)
    corridors(plan)
    doors(plan)
    furnish_south(plan)
    furnish_north(plan)
    furnish_wings(plan)
    furnish_core(plan)
    furnish_corridors(plan)
    return plan, (2.4, 6.45, 0.0), stops()


def rooms(plan):
    for left, right in zip(SOUTH_WALLS, SOUTH_WALLS[1:]):
        plan.room(left + 0.15, 0.15, right, 5.35)
    for left, right in zip(NORTH_WALLS, NORTH_WALLS[1:]):
        plan.room(left + 0.15, 19.65, right, 24.85)
    plan.room(0.15, 7.55, 5.45, 17.45)        # west wing: open-plan office
    plan.room(34.55, 7.55, 39.85, 12.40)      # east wing: library
    plan.room(34.55, 12.55, 39.85, 17.45)     # east wing: studio
    plan.room(7.55, 7.55, 13.20, 12.40)       # meeting room
    plan.room(13.35, 7.55, 18.95, 12.40)      # kitchen
    plan.room(7.55, 12.55, 12.00, 17.45)      # archive
    plan.room(14.95, 12.55, 18.95, 17.45)     # print room
    plan.room(21.05, 7.55, 32.45, 13.00)      # open-plan office
    plan.room(21.05, 13.15, 27.50, 17.45)     # conference room
    plan.room(27.65, 13.15, 32.45, 17.45)     # lounge


def corridors(plan):
    plan.room(0.15, 5.50, 39.85, 7.40)
    plan.room(0.15, 17.60, 39.85, 19.50)
    for left in (5.60, 19.10, 32.60):
        plan.room(left, 7.55, left + 1.80, 17.45)
        for y in (7.475, 17.525):
            plan.door(left + 0.9, y, width=1.50)    # a fire door, open


def doors(plan):
    for index, x in enumerate(SOUTH_DOORS):
        plan.door(x, 5.425, leaf=-1 if index % 2 else 0)
    for index, x in enumerate(NORTH_DOORS):
        plan.door(x, 19.575, leaf=0 if index % 2 else 1)
    for x, y in ((13.425, 2.40), (26.475, 1.80), (6.075, 21.00), (27.075, 23.20)):
        plan.door(x, y, vertical=True)              # from room to room
    plan.door(5.525, 9.60, vertical=True, leaf=-1)
    plan.door(5.525, 15.60, vertical=True)
    plan.door(34.475, 10.20, vertical=True, leaf=1)
    plan.door(34.475, 14.80, vertical=True)
    plan.door(7.475, 9.20, vertical=True, leaf=1)
    plan.door(19.025, 11.00, vertical=True)
    plan.door(10.40, 17.525, leaf=-1)
    plan.door(19.025, 14.60, vertical=True, leaf=-1)
    plan.door(20.975, 9.40, vertical=True)
    plan.door(32.525, 11.40, vertical=True, leaf=-1)
    plan.door(23.00, 17.525, leaf=-1)
    plan.door(32.525, 15.20, width=2.40, vertical=True)
    plan.pane(26.00, 17.525, 2.00)                  # glass front of the conference room
    plan.pane(7.475, 11.20, 1.40, vertical=True)    # and of the meeting room
    plan.pane(36.60, 12.475, 1.20)                  # window between library and studio


def furnish_south(plan):
    for x, y in ((1.0, 1.2), (4.2, 1.2), (8.2, 1.0), (10.6, 1.0), (21.2, 0.6), (23.6, 0.6),
                 (34.2, 1.4), (37.2, 1.4)):
        plan.desk(x, y, chair='above')
    plan.desk(16.8, 1.9, 1.8, 0.8, chair='below')
    plan.box(0.15, 3.20, 0.45, 1.60)
    plan.box(7.20, 3.40, 0.45, 1.80, DARK)
    plan.box(18.30, 4.90, 1.60, 0.45)
    plan.box(13.50, 0.15, 2.00, 0.40)
    plan.box(20.05, 3.20, 0.40, 2.00)
    plan.box(30.80, 0.15, 2.05, 0.50)
    plan.table(29.40, 1.90, 2.20, 1.10)
    for x in (29.8, 31.2):
        plan.chair(x, 3.35)
        plan.chair(x, 1.55)
    plan.box(39.40, 3.20, 0.45, 2.00, DARK)
    for x, y in ((6.70, 0.50), (19.50, 0.55), (26.05, 5.00), (33.40, 4.95)):
        plan.disc(x, y, 0.22)


def furnish_north(plan):
    for x, y in ((0.9, 23.6), (3.3, 23.6), (7.6, 23.4), (10.2, 23.4), (21.4, 23.6), (34.6, 23.4),
                 (37.4, 23.4)):
        plan.desk(x, y, chair='below')
    plan.table(15.00, 21.90, 3.60, 1.20)
    for x in (15.5, 16.8, 18.1):
        plan.chair(x, 21.55)
        plan.chair(x, 23.45)
    plan.box(13.05, 24.40, 2.60, 0.45)
    plan.box(19.95, 20.40, 0.45, 2.40, DARK)
    plan.box(0.15, 20.40, 0.40, 1.40)
    plan.box(12.45, 20.20, 0.45, 1.80)
    plan.box(24.40, 19.65, 2.20, 0.45)
    plan.table(28.60, 21.20, 1.60, 0.80)
    plan.chair(29.40, 22.40)
    plan.box(32.90, 21.60, 0.50, 2.60)
    plan.box(33.55, 19.65, 1.80, 0.40, DARK)
    for x, y in ((12.50, 24.45), (26.60, 21.20), (33.00, 20.05), (39.45, 20.05)):
        plan.disc(x, y, 0.22)


def furnish_wings(plan):
    for y in (8.6, 11.4, 14.2):
        plan.desk(0.50, y, chair='below')
        plan.desk(2.10, y, chair='below')
    plan.box(0.15, 17.00, 2.60, 0.45)
    plan.box(5.00, 11.60, 0.45, 2.20, DARK)
    plan.disc(4.95, 17.00, 0.22)
    for x in (36.4, 37.9):
        plan.box(x, 7.55, 0.40, 1.60)               # bookshelves
        plan.box(x, 10.60, 0.40, 1.80)
    plan.box(39.40, 8.00, 0.45, 3.60)
    plan.table(36.60, 13.60, 1.80, 0.90)
    plan.chair(37.50, 14.90)
    plan.box(37.40, 17.00, 2.45, 0.45)
    plan.box(39.35, 13.40, 0.50, 1.20, DARK)


def furnish_core(plan):
    plan.table(9.60, 9.90, 2.40, 1.10)
    for x in (10.1, 11.4):
        plan.chair(x, 9.55)
        plan.chair(x, 11.35)
    plan.box(12.80, 8.40, 0.40, 1.60, DARK)         # screen
    plan.box(13.35, 7.55, 3.60, 0.60)               # kitchen counter
    plan.box(18.35, 7.55, 0.60, 0.70)               # fridge
    plan.table(14.40, 9.90, 1.20, 0.80)
    plan.chair(15.00, 11.15)
    plan.chair(15.00, 9.50)
    plan.box(7.55, 13.20, 0.45, 3.40)               # archive shelves
    plan.box(9.40, 12.55, 0.45, 2.00)
    plan.box(11.55, 13.20, 0.45, 3.00)
    plan.box(14.95, 15.90, 0.80, 1.20, DARK)        # printers
    plan.box(15.80, 12.55, 2.40, 0.50)
    for y in (8.6, 10.9):
        for x in (23.0, 24.7, 27.6, 29.3):
            plan.desk(x, y, chair='below' if y < 9 else 'above')
    plan.disc(26.75, 10.30, 0.25)                   # pillars
    plan.disc(21.90, 12.20, 0.25)
    plan.table(23.20, 14.60, 2.80, 1.20)
    for x in (23.7, 25.4):
        plan.chair(x, 14.25)
        plan.chair(x, 16.15)
    plan.box(27.00, 14.00, 0.50, 1.60)
    plan.box(28.00, 13.15, 2.20, 0.80)              # sofas
    plan.box(27.65, 14.60, 0.80, 2.00)
    plan.disc(29.80, 15.30, 0.35)
    plan.box(31.20, 17.00, 1.20, 0.45, DARK)        # drinks machine


def furnish_corridors(plan):
    for x, width in ((2.20, 1.00), (9.20, 0.60), (17.40, 1.20), (22.40, 0.50), (30.60, 1.00),
                     (37.90, 0.80)):
        plan.box(x, 7.15, width, 0.25)              # benches, cabinets, radiators
    for x, width in ((4.40, 0.80), (13.60, 1.20), (18.40, 0.50), (25.00, 0.90), (34.60, 0.70)):
        plan.box(x, 19.25, width, 0.25)
    for x in (7.10, 13.40, 19.95, 26.40, 32.90):
        plan.box(x, 5.50, 0.25, 0.15)               # pilasters where the rooms' walls end
    for x in (1.60, 8.40, 14.90, 28.80, 36.00):
        plan.box(x, 17.60, 0.30, 0.15)
    for y in (12.10, 14.00):
        plan.box(5.60, y, 0.15, 0.30)
    plan.box(20.55, 12.40, 0.35, 0.90, DARK)        # copier
    plan.box(32.60, 8.60, 0.25, 0.80)
    plan.box(34.15, 12.80, 0.25, 0.50)
    plan.box(18.00, 5.50, 0.90, 0.35, DARK)         # drinks machine
    plan.box(28.20, 19.20, 1.00, 0.30, DARK)
    for x, y in ((0.45, 7.10), (39.50, 5.85), (21.40, 17.85), (39.50, 19.15), (0.50, 19.15),
                 (21.20, 7.15), (7.10, 16.90)):
        plan.disc(x, y, 0.20)                       # plants
    for left in (1.0, 3.3):                         # stairwell behind closed doors
        plan.pane(12.15 + left - 0.15, 17.525, 1.0, grey=DARK)


def stops():
    """South rooms, up the east side, down the middle (one loop), up the west (the other)."""
    south = [(4.2, 6.45), (4.2, 4.5), (4.2, 6.45), (11.4, 6.45), (11.4, 3.6), (15.2, 2.9),
             (15.2, 6.45), (24.0, 6.45), (24.0, 4.2), (25.4, 1.8), (28.0, 2.2), (28.6, 6.45)]
    east = [(36.6, 6.45), (36.6, 4.4), (36.6, 6.45), (33.6, 6.6), (33.5, 10.2), (35.5, 10.2),
            (33.5, 10.6), (33.5, 14.8), (35.8, 14.8), (33.5, 15.2), (30.8, 15.8), (33.5, 15.4),
            (33.5, 18.5), (37.4, 18.5), (37.4, 20.8), (37.4, 18.5), (31.2, 18.6), (31.2, 21.6),
            (28.2, 23.2), (25.8, 23.0), (22.6, 20.9), (22.6, 18.5), (23.0, 16.5), (22.6, 18.5)]
    middle = [(20.0, 18.4), (20.0, 14.6), (17.9, 14.6), (20.0, 14.2), (20.0, 11.0), (17.8, 10.9),
              (20.0, 10.4), (20.0, 9.4), (22.2, 9.7), (24.4, 9.8), (22.2, 9.7), (20.0, 9.4)]
    west = [(20.0, 6.45), (6.5, 6.6), (6.5, 9.0), (8.9, 8.9), (6.4, 9.4), (4.4, 10.2), (4.4, 15.8),
            (6.4, 15.6), (6.4, 18.4), (2.4, 18.5), (2.4, 20.6), (4.6, 21.2), (10.6, 21.2),
            (10.6, 18.5), (10.4, 15.8), (10.6, 18.5), (16.8, 18.5), (16.8, 20.8), (16.8, 18.5),
            (20.0, 18.4)]
    return south + east + middle + west
