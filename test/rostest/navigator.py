#!/usr/bin/python3
"""The node navigator, by clients of the real actionlib: it stands where move_base stands."""
import math
import pathlib
import threading
import unittest

import actionlib
import numpy
import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from nav_msgs.srv import GetPlan
from omega_slam.msg import PoseGraph
from sensor_msgs.msg import PointCloud2
from sensor_msgs.point_cloud2 import create_cloud_xyz32
from std_msgs.msg import Header
from std_srvs.srv import Empty

from simulator_support import Recorder, refusal, wait_until
from synthetic import Pose, poseGraph

START = (0.78, 0.78)
FAR = (3.57, 2.18)  # six metres of corridor away
WALLED_IN = (9.17, 9.17)
RESOLUTION = 0.05


def mazeMap(path):
    """The map of the maze, with walls drawn all about one place."""
    data = pathlib.Path(path).read_bytes()
    header, width, height = data.split(b'\n255\n', 1)[0].split(b'\n'), 200, 200
    assert header[0] == b'P5'
    grey = numpy.frombuffer(data[-width * height:], numpy.uint8).reshape(height, width)[::-1]
    cells = numpy.where(grey < 90, 100, 0).astype(numpy.int8)
    col, row = (int(c / RESOLUTION) for c in WALLED_IN)
    cells[row - 10:row + 11, [col - 10, col + 10]] = 100
    cells[[row - 10, row + 10], col - 10:col + 11] = 100
    grid = OccupancyGrid()
    grid.header.frame_id = 'map'
    grid.info.resolution, grid.info.width, grid.info.height = RESOLUTION, width, height
    grid.info.origin.orientation.w = 1.0
    grid.data = cells.flatten().tolist()
    return grid


class Localiser:
    """Says where the odometry's frame is in the map, ten times a second, unless it is muted."""

    def __init__(self):
        self.muted = threading.Event()
        self._broadcaster = tf2_ros.TransformBroadcaster()
        self._subscriber = rospy.Subscriber('odom', Odometry, self._speak, queue_size=1)
        self._last = 0.0

    def _speak(self, odometry):
        stamp = odometry.header.stamp.to_sec()
        if self.muted.is_set() or abs(stamp - self._last) < 0.1:
            return
        self._last = stamp
        transform = TransformStamped()
        transform.header.stamp = odometry.header.stamp + rospy.Duration(0.1)
        transform.header.frame_id, transform.child_frame_id = 'map', 'odom'
        transform.transform.translation.x, transform.transform.translation.y = START
        transform.transform.rotation.w = 1.0
        self._broadcaster.sendTransform(transform)


def pose(x, y, frame='map', yaw=0.0):
    stamped = PoseStamped()
    stamped.header.frame_id = frame
    stamped.pose.position.x, stamped.pose.position.y = x, y
    stamped.pose.orientation.z, stamped.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return stamped


class NavigatorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.localiser = Localiser()
        cls.map = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        cls.map.publish(mazeMap(rospy.get_param('~map')))
        cls.truth = Recorder('base_pose_ground_truth', Odometry)
        cls.commands = Recorder('mobile_base/commands/velocity', Twist)
        cls.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        assert cls.client.wait_for_server(rospy.Duration(60.0))
        rospy.wait_for_service('move_base/make_plan', 30.0)
        cls.make_plan = rospy.ServiceProxy('move_base/make_plan', GetPlan)
        # Where it knows neither map nor pose nor scan yet, it makes no plans.
        wait_until(lambda: cls.make_plan(PoseStamped(), pose(*FAR), 0.0).plan.poses,
                   'the navigator to know where it is')

    def position(self):
        point = self.truth.last().pose.pose.position
        return point.x, point.y

    def send(self, target):
        goal = MoveBaseGoal()
        goal.target_pose = target
        self.client.send_goal(goal)

    def outcome(self):
        wait_until(lambda: self.client.get_state() not in
                   (GoalStatus.PENDING, GoalStatus.ACTIVE, GoalStatus.PREEMPTING), 'the goal to end')
        return self.client.get_state()

    def drive(self, x, y, yaw=0.0):
        self.send(pose(x, y, yaw=yaw))
        self.assertEqual(self.outcome(), GoalStatus.SUCCEEDED, self.client.get_goal_status_text())

    def waitUntilItStands(self):
        wait_until(lambda: self.truth.messages[-1].twist.twist.linear.x == 0.0, 'the robot to stand')

    def waitUntilItDrives(self):
        wait_until(lambda: self.truth.messages[-1].twist.twist.linear.x > 0.2, 'the robot to drive')

    def refused(self, target, *words):
        self.send(target)
        self.assertEqual(self.outcome(), GoalStatus.ABORTED)
        for word in words:
            self.assertIn(word, self.client.get_goal_status_text())

    def test_drives_to_a_goal_and_takes_its_heading(self):
        self.drive(2.18, 2.18, yaw=2.0)
        self.waitUntilItStands()
        self.assertLess(math.dist(self.position(), (2.18, 2.18)), 0.2)
        rotation = self.truth.messages[-1].pose.pose.orientation
        yaw = 2.0 * math.atan2(rotation.z, rotation.w)
        self.assertLess(abs(math.remainder(yaw - 2.0, 2.0 * math.pi)), 0.25)

    def test_goals_that_cannot_be_reached_are_refused_with_the_reason(self):
        self.refused(pose(1.475, 0.05), 'obstacle')
        self.refused(pose(100.0, 0.0), 'outside')
        self.refused(pose(*WALLED_IN), 'no way')
        self.refused(pose(math.nan, 0.0), 'finite')
        self.refused(pose(*FAR, frame='moon'), 'moon')
        bad = pose(*FAR)
        bad.pose.orientation.w = bad.pose.orientation.z = 0.0
        self.refused(bad, 'finite')

    def test_preempts_and_stands(self):
        self.drive(*START)
        self.send(pose(*FAR))
        self.waitUntilItDrives()
        self.client.cancel_goal()
        self.assertEqual(self.outcome(), GoalStatus.PREEMPTED)
        self.waitUntilItStands()

    def test_a_new_goal_takes_the_place_of_the_old_one(self):
        self.drive(*START)
        self.send(pose(*FAR))
        self.waitUntilItDrives()
        self.drive(*START)
        self.waitUntilItStands()
        self.assertLess(math.dist(self.position(), START), 0.2)

    def test_survives_a_second_without_tf(self):
        self.drive(*START)
        self.send(pose(*FAR))
        self.waitUntilItDrives()
        self.localiser.muted.set()
        try:
            self.waitUntilItStands()  # nothing invents where it is
            stamp = self.truth.messages[-1].header.stamp
            wait_until(lambda: (self.truth.messages[-1].header.stamp - stamp).to_sec() > 1.0,
                       'a second to pass')
        finally:
            self.localiser.muted.clear()
        self.assertEqual(self.outcome(), GoalStatus.SUCCEEDED, self.client.get_goal_status_text())
        self.assertLess(math.dist(self.position(), FAR), 0.2)

    def test_listens_to_simple_goals_and_shows_its_plan(self):
        plans = Recorder('plan', Path)
        simple = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
        wait_until(lambda: simple.get_num_connections() > 0, 'the navigator to listen')
        simple.publish(pose(2.18, 0.78))
        wait_until(lambda: math.dist(self.position(), (2.18, 0.78)) < 0.15, 'the robot to arrive')
        end = plans.last().poses[-1].pose.position
        self.assertLess(math.dist((end.x, end.y), (2.18, 0.78)), 0.01)
        self.waitUntilItStands()

    def test_makes_plans_without_driving_them(self):
        plan = self.make_plan(pose(*START), pose(*FAR), 0.1).plan
        self.assertEqual(plan.header.frame_id, 'map')
        points = [(p.pose.position.x, p.pose.position.y) for p in plan.poses]
        self.assertLess(math.dist(points[0], START), 1e-6)
        self.assertLess(math.dist(points[-1], FAR), 1e-6)
        self.assertEqual(self.make_plan(pose(*START), pose(*WALLED_IN), 0.1).plan.poses, [])
        self.assertEqual(self.make_plan(pose(*START), pose(0, 0, frame='moon'), 0.1).plan.poses, [])

    def test_shows_its_costmap_and_clears_it(self):
        costmap = Recorder('costmap', OccupancyGrid).wait()[0]
        self.assertEqual(costmap.info.width, 200)
        self.assertEqual(costmap.data[0], 100)
        self.assertIn(99, costmap.data)
        rospy.ServiceProxy('move_base/clear_costmaps', Empty)()

    def test_what_it_has_touched_moves_with_the_graph(self):
        self.drive(*START)
        ahead = pose(START[0] + 0.35, START[1])
        def way():
            return self.make_plan(pose(*START), ahead, 0.0).plan.poses
        self.assertTrue(way())
        bumper = rospy.Publisher('mobile_base/sensors/bumper_pointcloud', PointCloud2, queue_size=1)
        graph = rospy.Publisher('pose_graph', PoseGraph, queue_size=1)
        wait_until(lambda: bumper.get_num_connections() and graph.get_num_connections(),
                   'the navigator to listen')
        graph.publish(poseGraph(1, [Pose(*START, 0.0)]))
        contact = create_cloud_xyz32(Header(frame_id='base_footprint'), [(0.18, 0.0, 0.0)])
        bumper.publish(contact)
        wait_until(lambda: not way(), 'the contact to stand in the way')
        graph.publish(poseGraph(1, [Pose(START[0], START[1] - 1.0, 0.0)]))
        wait_until(way, 'the contact to move')
        bumper.publish(contact)
        wait_until(lambda: not way(), 'the next contact to stand in the way')
        graph.publish(poseGraph(2, [Pose(*START, 0.0)]))
        wait_until(way, 'contacts of another run to be forgotten')

    def test_asks_for_a_description_or_a_radius(self):
        said = refusal(self, 'navigator', 'bare_navigator', ['_description:=nobodys'])
        self.assertIn('nobodys', said)
        said = refusal(self, 'navigator', 'odd_navigator',
                       ['_follower/max_linear_speed:=-1.0', '_planner/planner:=magic', '_margn:=1'])
        for word in ('max_linear_speed', 'planner', 'margin'):
            self.assertIn(word, said)


if __name__ == '__main__':
    import rostest
    rospy.init_node('navigator_test')
    rostest.rosrun('omega_slam', 'navigator', NavigatorTest)
