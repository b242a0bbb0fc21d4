#!/usr/bin/env python3
"""frontier_explorer: goals from a map and a pose, its services, and what does not disturb it."""
import pathlib
import sys
import threading
import time

import actionlib
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseResult
from nav_msgs.msg import OccupancyGrid
from omega_slam.msg import ExplorationStatus
from omega_slam.srv import SetStrategy
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest, waitUntil  # noqa: E402  (it lies beside this file)

NAME = 'frontier_explorer'
WIDTH, HEIGHT, RESOLUTION = 80, 60, 0.05  # of a room of 4 m x 3 m


def room(openings):
    """A map of one room; openings are cells (column, row) of its wall that are unknown."""
    grid = OccupancyGrid()
    grid.header.frame_id = 'map'
    grid.header.stamp = rospy.Time.now()
    grid.info.resolution = RESOLUTION
    grid.info.width, grid.info.height = WIDTH, HEIGHT
    grid.info.origin.orientation.w = 1.0
    grid.data = [0 if 0 < col < WIDTH - 1 and 0 < row < HEIGHT - 1 else
                 -1 if (col, row) in openings else 100
                 for row in range(HEIGHT) for col in range(WIDTH)]
    return grid


EAST = {(WIDTH - 1, row) for row in range(20, 40)}
NORTH = {(col, HEIGHT - 1) for col in range(10, 30)}


class Driver:
    """A move_base that keeps its goals, and ends them as it is told."""

    def __init__(self):
        self.goals = []
        self.cancelled = 0
        self._verdict = None
        self._lock = threading.Lock()
        self.server = actionlib.SimpleActionServer('move_base', MoveBaseAction, self._drive, False)
        self.server.start()

    def _drive(self, goal):
        with self._lock:
            self.goals.append(goal.target_pose)
            self._verdict = None
        while not rospy.is_shutdown():
            if self.server.is_preempt_requested():
                self.cancelled += 1
                self.server.set_preempted(MoveBaseResult())
                return
            if self._verdict is not None:
                (self.server.set_succeeded if self._verdict else self.server.set_aborted)(
                    MoveBaseResult())
                return
            time.sleep(0.01)

    def end(self, reached):
        self._verdict = reached

    def waitForGoals(self, count):
        waitUntil(lambda: len(self.goals) >= count, lambda: f'{count} goals; {len(self.goals)} came')
        return self.goals[count - 1].pose.position


class FrontierExplorerTest(NodeTest):

    @classmethod
    def setUpClass(cls):
        cls.driver = Driver()

    def start(self, openings, **parameters):
        self.driver.goals.clear()
        self.driver.cancelled = 0
        self.tf = self.advertise('/tf', TFMessage)
        self.maps = self.advertise('map', OccupancyGrid, latch=True)
        self.has_pose = True
        timer = rospy.Timer(rospy.Duration(0.05), self.publishPose)
        self.addCleanup(timer.shutdown)
        self.node = self.startNode(NAME, {'decision_interval': 0.1, 'settle_time': 0.1,
                                          'update_rate': 20.0, **parameters})
        self.status = self.listen('exploration_status', ExplorationStatus)
        self.connect(self.status, self.maps)
        self.maps.publish(room(openings))

    def publishPose(self, _):
        if not self.has_pose:
            return
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'base_footprint'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x, transform.transform.translation.y = 1.5, 1.0
        transform.transform.rotation.w = 1.0
        self.tf.publish(TFMessage([transform]))

    def ask(self, service, request=Trigger, *arguments):
        rospy.wait_for_service(f'{NAME}/{service}', 20.0)
        return rospy.ServiceProxy(f'{NAME}/{service}', request)(*arguments)

    def waitForPhase(self, phase):
        return self.status.waitFor(lambda m: m.phase == phase, phase)

    def testGoesToTheNearestFrontierAndEndsWhenAllAreGone(self):
        self.start(EAST | NORTH, strategy='nearest_to_robot', return_home=False)
        first = self.driver.waitForGoals(1)
        self.assertAlmostEqual(first.y, 2.7, delta=0.15)  # the northern one, from where there is room
        self.assertLess(first.x, 1.6)
        self.maps.publish(room(EAST))
        second = self.driver.waitForGoals(2)
        self.assertAlmostEqual(second.x, 3.7, delta=0.15)
        self.assertTrue(1.0 < second.y < 2.0)
        self.maps.publish(room(set()))
        ended = self.waitForPhase('ended')
        self.assertEqual(ended.ending, 'done')
        self.assertEqual(ended.goals, 2)
        self.assertAlmostEqual(ended.share, 1.0)

    def testStartsPausesResumesAndStopsWhenAsked(self):
        self.start(EAST, auto_start=False)
        self.waitForPhase('idle')
        self.assertFalse(self.ask('stop').success)
        self.assertTrue(self.ask('start').success)
        self.driver.waitForGoals(1)
        self.assertTrue(self.ask('pause').success)
        waitUntil(lambda: self.driver.cancelled == 1, 'the goal is cancelled')
        self.assertFalse(self.ask('pause').success)
        self.assertTrue(self.ask('resume').success)
        self.driver.waitForGoals(2)
        self.assertTrue(self.ask('stop').success)
        waitUntil(lambda: self.driver.cancelled == 2, 'the goal is cancelled')
        self.assertEqual(self.waitForPhase('ended').ending, 'stopped')
        self.assertEqual(len(self.driver.goals), 2)

    def testAGapInTfOfASecondChangesNothing(self):
        self.start(EAST)
        self.driver.waitForGoals(1)
        self.has_pose = False
        self.status.waitFor(lambda m: 'pose' in m.reason, 'it waits for a pose')
        self.has_pose = True
        self.status.clear()
        self.status.waitFor(lambda m: m.phase == 'exploring' and not m.reason, 'it goes on')
        self.assertEqual((len(self.driver.goals), self.driver.cancelled), (1, 0))
        self.maps.publish(room(NORTH))
        self.driver.waitForGoals(2)

    def testWhatIsNotReachedIsSetAsideAndTriedAgain(self):
        self.start(EAST, max_attempts=2, set_aside_time=0.5, return_home=False)
        first = self.driver.waitForGoals(1)
        self.driver.end(False)
        second = self.driver.waitForGoals(2)
        self.assertGreater(abs(first.x - second.x) + abs(first.y - second.y), 0.25)
        self.driver.end(False)
        ended = self.waitForPhase('ended')
        self.assertEqual((ended.ending, ended.set_aside), ('stuck', 1))

    def testTheStrategyIsChangedUnderWay(self):
        self.start(EAST | NORTH, strategy='nearest_to_robot')
        self.driver.waitForGoals(1)
        self.assertFalse(self.ask('set_strategy', SetStrategy, 'best').success)
        self.assertTrue(self.ask('set_strategy', SetStrategy, 'along_route').success)
        second = self.driver.waitForGoals(2)
        self.assertGreater(second.x, 3.0)  # straight ahead
        self.status.waitFor(lambda m: m.strategy == 'along_route', 'the new strategy')

    def testMapsThatMakeNoSenseAreRefused(self):
        self.start(EAST)
        self.driver.waitForGoals(1)
        foreign = room(NORTH)
        foreign.header.frame_id = 'elsewhere'
        self.maps.publish(foreign)
        self.waitForRejections(NAME, 'map of another frame', 1)
        broken = room(NORTH)
        broken.data = broken.data[1:]
        self.maps.publish(broken)
        self.waitForRejections(NAME, 'map that makes no sense', 1)
        self.assertEqual(len(self.driver.goals), 1)

    def testBadParametersAreNamed(self):
        self.checkBadParameters(NAME, [
            ({'strategy': 'nearest'}, ['frontier_explorer/strategy', 'nearest_to_robot']),
            ({'robot_radius': -1.0}, ['frontier_explorer/robot_radius']),
            ({'area': [1.0, 2.0]}, ['area']),
            ({'return_hom': True}, ['return_hom', 'return_home'])])


if __name__ == '__main__':
    rospy.init_node('frontier_explorer_test')
    rostest.rosrun('omega_slam', 'frontier_explorer_test', FrontierExplorerTest)
