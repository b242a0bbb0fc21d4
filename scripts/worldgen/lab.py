"""A university robotics lab: hall, workshop, store, corridor, seminar room, two offices."""
from .plan import DARK, Plan

DESCRIPTION = ('A university lab of 11 x 18 m: a hall with desks, workshop, store, corridor with a '
               'glass door, seminar room and two offices.')


def draw():
    plan = Plan(11.0, 18.0)
    rooms(plan)
    doors(plan)
    furnish_hall(plan)
    furnish_workshop_and_store(plan)
    furnish_corridor(plan)
    furnish_seminar_room(plan)
    furnish_offices(plan)
    return plan, (1.2, 3.4, 0.0), stops()


def rooms(plan):
    plan.room(0.15, 0.15, 7.40, 7.85)      # hall
    plan.room(7.55, 0.15, 10.85, 4.60)     # workshop
    plan.room(7.55, 4.75, 10.85, 7.85)     # store
    plan.room(0.15, 8.00, 1.60, 10.00)     # porch
    plan.room(1.75, 8.00, 10.85, 10.00)    # corridor
    plan.room(0.15, 10.15, 5.60, 17.85)    # seminar room
    plan.room(5.75, 10.15, 10.85, 13.80)   # office A
    plan.room(5.75, 13.95, 10.85, 17.85)   # office B


def doors(plan):
    plan.door(2.60, 7.925, leaf=-1)                    # hall - corridor, west
    plan.door(6.40, 7.925, leaf=-1)                    # hall - corridor, east
    plan.door(7.475, 2.40, vertical=True, leaf=1)      # hall - workshop
    plan.door(9.60, 7.925, leaf=-1)                    # store - corridor
    plan.door(3.90, 10.075, width=1.10, leaf=1)        # seminar room - corridor
    plan.door(7.60, 10.075, leaf=1)                    # office A - corridor
    plan.door(9.70, 13.875, leaf=1)                    # office A - office B
    plan.door(5.675, 15.90, vertical=True, leaf=1)     # office B - seminar room
    plan.pane(1.675, 9.00, 1.30, vertical=True)        # glass door to the porch
    plan.pane(5.10, 10.075, 0.60)                      # glass beside the seminar room's door


def furnish_hall(plan):
    for y in (1.05, 4.60):
        for x in (2.60, 4.40):
            plan.desk(x, y, chair='below')
            plan.desk(x, y + 0.80, chair='above')
    plan.box(0.15, 6.60, 0.45, 1.20)                   # cupboards
    plan.box(0.15, 5.20, 0.45, 1.35, DARK)             # rack of robot parts
    plan.box(3.60, 7.45, 1.80, 0.40)                   # shelf
    plan.box(0.15, 0.15, 1.60, 0.60)                   # printer bench
    plan.disc(6.75, 3.95, 0.20)                        # pillar
    plan.box(6.90, 0.15, 0.50, 0.80, DARK)             # server cabinet
    plan.disc(0.50, 1.90, 0.18)                        # bin
    plan.chair(0.70, 4.50)


def furnish_workshop_and_store(plan):
    plan.box(10.15, 0.80, 0.70, 2.80)                  # workbench
    plan.box(7.55, 0.15, 1.80, 0.55, DARK)             # lathe
    plan.table(8.30, 3.75, 1.60, 0.80)
    plan.chair(9.55, 1.30)
    plan.box(7.55, 4.75, 0.45, 3.05)                   # shelves
    plan.box(8.20, 4.75, 2.65, 0.45)
    plan.box(10.40, 5.45, 0.45, 1.10, DARK)            # battery cabinet
    plan.disc(8.45, 7.35, 0.22)                        # barrel


def furnish_corridor(plan):
    plan.box(4.60, 8.00, 0.90, 0.35)                   # bench
    plan.box(7.80, 8.00, 0.90, 0.40, DARK)             # copier
    plan.box(5.70, 9.80, 0.80, 0.20)                   # notice board
    plan.disc(10.45, 9.60, 0.20)                       # plant
    plan.box(10.70, 8.60, 0.15, 0.40)                  # fire hose
    plan.box(2.20, 9.85, 0.50, 0.15)                   # letter boxes
    plan.box(0.15, 8.00, 0.40, 0.90)                   # porch: umbrella stand
    plan.disc(1.20, 9.65, 0.18)


def furnish_seminar_room(plan):
    plan.table(1.90, 12.30, 1.00, 1.80)
    plan.table(1.90, 14.15, 1.00, 1.80)
    for y in (12.75, 13.65, 14.60, 15.50):
        plan.chair(1.55, y)
        plan.chair(3.25, y)
    plan.box(1.40, 17.70, 2.40, 0.15)                  # blackboard
    plan.box(0.15, 10.15, 1.50, 0.50)                  # sideboard
    plan.box(0.15, 16.60, 0.50, 1.25, DARK)            # projector cabinet
    plan.disc(5.25, 17.45, 0.22)                       # plant


def furnish_offices(plan):
    plan.desk(9.15, 11.00, chair='above')
    plan.box(5.75, 13.30, 2.30, 0.50)                  # bookshelf
    plan.desk(5.85, 11.70, chair='below')
    plan.box(10.45, 12.40, 0.40, 0.90, DARK)           # safe
    plan.desk(6.60, 16.95, chair='below')
    plan.desk(8.80, 16.95, chair='below')
    plan.box(6.40, 13.95, 1.80, 0.40)                  # shelf
    plan.disc(10.45, 14.35, 0.20)                      # plant
    plan.chair(10.30, 15.60)


def stops():
    """Hall, workshop, store, corridor, both offices, seminar room, and home by the other door."""
    return [(6.4, 2.4), (9.0, 2.4), (6.4, 2.4), (6.5, 7.1), (6.4, 9.0), (9.6, 9.0), (9.4, 6.4),
            (9.6, 9.0), (7.6, 9.1), (7.8, 11.6), (9.7, 13.2), (9.7, 15.0), (7.3, 15.5),
            (4.6, 15.9), (3.4, 16.8), (1.0, 15.9), (0.9, 11.6), (3.9, 11.2), (3.9, 9.1),
            (2.6, 9.0), (2.6, 7.1), (1.6, 6.4), (1.2, 3.4)]
