#!/usr/bin/python3
"""The node simulator, seen from outside: what a TurtleBot says and does."""
import math
import unittest

import rospy
import sensor_msgs.point_cloud2
import tf2_msgs.msg
import yaml
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState, LaserScan, PointCloud2
from std_msgs.msg import Empty as EmptyMessage
from std_srvs.srv import Empty

from simulator_support import DEADLINE, Recorder, wait_until

STEP = 0.02  # [s] of simulated time


def yaw(message):
    return 2.0 * math.atan2(message.pose.pose.orientation.z, message.pose.pose.orientation.w)


class Driver:
    """Publishes one command over and over, as a joystick does, until told to let go."""

    def __init__(self, publisher, linear, angular=0.0):
        self.twist = Twist()
        self.twist.linear.x, self.twist.angular.z = linear, angular
        self.publisher = publisher

    def drive_until(self, condition, what):
        def published():
            self.publisher.publish(self.twist)
            return condition()
        wait_until(published, what)


class SimulatorTest(unittest.TestCase):
    """In the maze, where the robot starts two metres in front of a wall."""

    @classmethod
    def setUpClass(cls):
        with open(rospy.get_param('~world'), encoding='utf-8') as world:
            cls.start = yaml.safe_load(world)['start']

    def setUp(self):
        self.command = rospy.Publisher('mobile_base/commands/velocity', Twist, queue_size=1)
        self.truth = Recorder('base_pose_ground_truth', Odometry)
        wait_until(lambda: self.command.get_num_connections() > 0, 'the simulator to listen')
        rospy.wait_for_service('reset_positions', DEADLINE)
        self.reset = rospy.ServiceProxy('reset_positions', Empty)
        self.reset()
        wait_until(lambda: self.speed() == 0.0 and self.distance_to_start() < 1e-6,
                   'the robot to stand at its start')

    def tearDown(self):
        self.truth.subscriber.unregister()

    def speed(self):
        twist = self.truth.last().twist.twist
        return abs(twist.linear.x) + abs(twist.angular.z)

    def distance_to_start(self):
        position = self.truth.last().pose.pose.position
        return math.hypot(position.x - self.start[0], position.y - self.start[1])

    def test_odometry_is_a_kobukis(self):
        odometry = Recorder('odom', Odometry).wait()[0]
        self.assertEqual(odometry.header.frame_id, 'odom')
        self.assertEqual(odometry.child_frame_id, 'base_footprint')
        diagonal = odometry.pose.covariance[::7]
        self.assertEqual(diagonal, (0.1, 0.1, 1e10, 1e10, 1e10, 0.05))

    def test_scan_is_a_hokuyos(self):
        scan = Recorder('scan', LaserScan).wait()[0]
        self.assertEqual(scan.header.frame_id, 'laser')
        self.assertEqual(len(scan.ranges), 683)
        self.assertAlmostEqual(scan.angle_min, -scan.angle_max, 6)
        self.assertAlmostEqual(math.degrees(scan.angle_max), 119.88, 2)
        self.assertAlmostEqual(scan.angle_min + 682 * scan.angle_increment, scan.angle_max, 4)
        self.assertAlmostEqual(scan.scan_time, 0.1, 6)
        self.assertAlmostEqual(scan.time_increment, 0.1 / 1024, 9)
        self.assertAlmostEqual(scan.range_min, 0.02, 6)
        self.assertAlmostEqual(scan.range_max, 4.0, 6)
        seen = [value for value in scan.ranges if not math.isnan(value)]
        self.assertGreater(len(seen), 300)
        self.assertTrue(all(0.02 <= value <= 4.0 for value in seen))
        # Behind the robot is the outer wall of the maze: there must be returns to the side.
        self.assertFalse(math.isnan(scan.ranges[-1]))

    def test_joints_are_those_of_the_description(self):
        joints = Recorder('joint_states', JointState).wait()[0]
        self.assertEqual(joints.name, ['wheel_left_joint', 'wheel_right_joint'])
        self.assertEqual(len(joints.position), 2)
        self.assertEqual(len(joints.velocity), 2)

    def test_truth_has_a_frame_of_its_own(self):
        truth = self.truth.last()
        self.assertEqual(truth.header.frame_id, 'world')
        self.assertEqual(truth.child_frame_id, 'base_footprint')
        self.assertAlmostEqual(yaw(truth), self.start[2], 6)

    def test_tf_is_odom_to_base_and_nothing_else(self):
        transforms = Recorder('/tf', tf2_msgs.msg.TFMessage)
        odometry = Recorder('odom', Odometry)
        transforms.wait(100)
        frames = {(transform.header.frame_id, transform.child_frame_id)
                  for message in transforms.messages for transform in message.transforms}
        self.assertEqual(frames, {('odom', 'base_footprint')})
        by_stamp = {message.transforms[0].header.stamp: message.transforms[0]
                    for message in list(transforms.messages)}
        common = [message for message in list(odometry.messages)
                  if message.header.stamp in by_stamp]
        self.assertGreater(len(common), 10)
        for message in common:
            transform = by_stamp[message.header.stamp].transform
            self.assertEqual(transform.translation.x, message.pose.pose.position.x)
            self.assertEqual(transform.rotation.z, message.pose.pose.orientation.z)

    def test_rates_in_simulated_time(self):
        for topic, message_type, period in (('odom', Odometry, STEP), ('joint_states', JointState, STEP),
                                            ('base_pose_ground_truth', Odometry, STEP),
                                            ('scan', LaserScan, 0.1)):
            stamps = [message.header.stamp.to_sec()
                      for message in Recorder(topic, message_type).wait(20)]
            for before, after in zip(stamps, stamps[1:]):
                self.assertAlmostEqual(after - before, period, 6, topic)

    def test_clock_goes_forward_in_steps(self):
        clocks = [message.clock.to_sec() for message in Recorder('/clock', Clock).wait(50)]
        for before, after in zip(clocks, clocks[1:]):
            # rospy listens to the clock itself, with a queue of one that it shares with us: on a
            # busy machine it skips some.
            steps = round((after - before) / STEP)
            self.assertGreaterEqual(steps, 1)
            self.assertAlmostEqual(after - before, steps * STEP, 6)

    def test_clock_is_never_behind_the_stamps(self):
        scan = Recorder('scan', LaserScan)
        clock = Recorder('/clock', Clock)
        scan.wait(5)
        newest = scan.messages[-1].header.stamp
        wait_until(lambda: clock.messages and clock.messages[-1].clock >= newest,
                   'the clock to reach the stamp of a scan')

    def test_drives_as_commanded_and_stops_without_commands(self):
        Driver(self.command, 0.3).drive_until(
            lambda: abs(self.truth.last().twist.twist.linear.x - 0.3) < 1e-6, 'the robot to drive')
        heard_last = self.truth.last().header.stamp.to_sec()
        wait_until(lambda: self.speed() == 0.0, 'the robot to stop')
        moving = [message for message in list(self.truth.messages)
                  if message.twist.twist.linear.x > 0.299]
        stopped = self.truth.last().header.stamp.to_sec()
        # The last command may have come in a little later than the last truth before it.
        kept_going = moving[-1].header.stamp.to_sec() - heard_last
        self.assertGreater(kept_going, 0.6 - 2 * STEP)
        self.assertLess(kept_going, 0.6 + 1.0)
        self.assertLess(stopped - moving[-1].header.stamp.to_sec(), 0.3 / 0.8 + 0.5)
        self.assertGreater(self.truth.last().pose.pose.position.x, self.start[0] + 0.1)

    def test_ignores_commands_that_are_no_numbers(self):
        Driver(self.command, math.nan, 0.5).drive_until(
            lambda: len(self.truth.messages) > 50, 'time to pass')
        self.assertEqual(self.speed(), 0.0)
        Driver(self.command, 0.1, math.inf).drive_until(
            lambda: len(self.truth.messages) > 100, 'time to pass')
        self.assertEqual(self.speed(), 0.0)
        self.assertLess(self.distance_to_start(), 1e-6)

    def test_bumps_into_a_wall_and_lets_go(self):
        bumper = Recorder('mobile_base/sensors/bumper_pointcloud', PointCloud2)
        wait_until(lambda: bumper.subscriber.get_num_connections() > 0, 'the bumper topic')
        Driver(self.command, 0.6).drive_until(lambda: bumper.messages, 'the robot to bump')
        cloud = bumper.messages[0]
        self.assertEqual(cloud.header.frame_id, 'base_link')
        left, centre, right = sensor_msgs.point_cloud2.read_points(cloud, ('x', 'y', 'z'))
        self.assertAlmostEqual(centre[0], 0.25, 5)
        self.assertAlmostEqual(centre[1], 0.0, 5)
        self.assertGreater(math.hypot(*left[:2]), 99.0)
        self.assertGreater(math.hypot(*right[:2]), 99.0)
        self.assertGreater(left[1], 0.0)
        self.assertLess(right[1], 0.0)
        self.assertEqual(self.truth.last().twist.twist.linear.x, 0.0)

        def idle():
            points = sensor_msgs.point_cloud2.read_points(bumper.messages[-1], ('x', 'y', 'z'))
            return all(math.hypot(*point[:2]) > 99.0 for point in points)
        Driver(self.command, -0.2).drive_until(idle, 'the bumper to be let go')

    def test_carried_back_the_odometry_does_not_know(self):
        odometry = Recorder('odom', Odometry)
        before = odometry.last().pose.pose.position
        Driver(self.command, 0.3).drive_until(lambda: self.distance_to_start() > 0.5, 'half a metre')
        self.reset()
        wait_until(lambda: self.distance_to_start() < 1e-6, 'the robot to be carried back')
        count = len(odometry.messages)
        wait_until(lambda: len(odometry.messages) > count + 2, 'odometry after that')
        after = odometry.last().pose.pose.position
        self.assertGreater(math.hypot(after.x - before.x, after.y - before.y), 0.4)

    def test_odometry_can_be_set_to_zero(self):
        odometry = Recorder('odom', Odometry)
        Driver(self.command, 0.3).drive_until(lambda: self.distance_to_start() > 0.3, 'some way')
        wait_until(lambda: self.speed() == 0.0, 'the robot to stop')
        publisher = rospy.Publisher('mobile_base/commands/reset_odometry', EmptyMessage,
                                    queue_size=1)
        wait_until(lambda: publisher.get_num_connections() > 0, 'the simulator to listen')
        publisher.publish(EmptyMessage())
        wait_until(lambda: odometry.last().pose.pose.position.x == 0.0, 'the odometry to be zero')
        self.assertGreater(self.distance_to_start(), 0.3)


if __name__ == '__main__':
    import rostest
    rospy.init_node('simulator_test')
    rostest.rosrun('omega_slam', 'simulator', SimulatorTest)
