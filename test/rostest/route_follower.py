#!/usr/bin/python3
"""The node route_follower: drives the simulated robot along its world's route."""
import math
import pathlib
import tempfile
import unittest

import rospy
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import String

from simulator_support import Recorder, refusal, wait_until


class RouteFollowerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.world = rospy.get_param('~world')
        with open(cls.world, encoding='utf-8') as world:
            cls.route = yaml.safe_load(world)['route']

    def test_drives_the_route_and_says_how_far_it_is(self):
        status = Recorder('route_status', String)
        commands = Recorder('mobile_base/commands/velocity', Twist)
        truth = Recorder('base_pose_ground_truth', Odometry)
        wait_until(lambda: status.messages and status.messages[-1].data == 'done', 'the route to end')
        said = [message.data for message in status.messages]
        # A late subscriber hears the last one only, so the first may be missing.
        self.assertEqual(said, ['driving 1/3', 'driving 2/3', 'driving 3/3', 'done'][-len(said):])
        wait_until(lambda: truth.last().twist.twist.linear.x == 0.0, 'the robot to stop')
        end = truth.last().pose.pose.position
        self.assertLess(math.dist((end.x, end.y), self.route[-1]), 0.15)
        self.assertTrue(all(abs(message.linear.x) <= 0.45 and abs(message.angular.z) <= 1.2
                            for message in commands.messages))
        self.says_it_is_done_to_those_who_come_late()
        self.leaves_the_robot_alone(commands, truth)

    def says_it_is_done_to_those_who_come_late(self):
        self.assertEqual(Recorder('route_status', String).wait()[0].data, 'done')

    def leaves_the_robot_alone(self, commands, truth):
        count, seen = len(commands.messages), len(truth.messages)
        wait_until(lambda: len(truth.messages) > seen + 50, 'a second to pass')
        self.assertLessEqual(len(commands.messages), count + 1)

    def lie(self, publisher, stamp, x, y):
        message = Odometry()
        message.header.stamp = rospy.Time.from_sec(stamp)
        message.pose.pose.position.x, message.pose.pose.position.y = x, y
        message.pose.pose.orientation.w = 1.0
        publisher.publish(message)

    def test_backs_off_and_gives_up_where_the_robot_does_not_move(self):
        publisher = rospy.Publisher('/fooled/base_pose_ground_truth', Odometry, queue_size=1)
        status = Recorder('/fooled/route_status', String)
        commands = Recorder('/fooled/cmd_vel', Twist)
        wait_until(lambda: publisher.get_num_connections() > 0 and
                   commands.subscriber.get_num_connections() > 0, 'the follower to listen')
        self.assertEqual(status.wait()[0].data, 'driving 1/3')

        # Nothing may come of poses that are none.
        reports = Recorder('/diagnostics', DiagnosticArray)

        def refused():
            self.lie(publisher, 1.0, math.nan, 0.0)
            return any('true pose is not a finite pose' in value.key
                       for message in list(reports.messages) for one in message.status
                       for value in one.values)
        wait_until(refused, 'the refusal to be counted')
        self.assertEqual(commands.messages, [])

        stamps = [1.0]

        def gave_up():
            stamps[0] += 0.1
            self.lie(publisher, stamps[0], 0.78, 0.78)
            return status.messages[-1].data.startswith('stuck: ')
        wait_until(gave_up, 'the follower to give up')
        self.assertRegex(status.messages[-1].data,
                         r'stuck: waypoint 1 at \(1\.60, 0\.78\) cannot be reached from .*')
        wait_until(lambda: commands.messages[-1].linear.x == 0.0, 'the last command, to stop')
        self.assertTrue(any(message.linear.x < 0.0 for message in commands.messages))

    def refuse(self, name, *arguments):
        return refusal(self, 'route_follower', f'route_follower_{name}', arguments)

    def test_names_an_unknown_key_and_the_nearest_known_one(self):
        said = self.refuse('unknown', f'_world:={self.world}', '_max_bump:=1')
        self.assertRegex(said, r'route_follower_unknown/max_bump\b.*\bmax_bumps\b')

    def test_names_a_key_of_the_wrong_type_or_out_of_range(self):
        said = self.refuse('wrong', f'_world:={self.world}', '_look_ahead:=far',
                           '_corner_speed:=-0.1')
        self.assertIn('look_ahead', said)
        self.assertIn('corner_speed', said)

    def test_asks_for_a_world(self):
        self.assertIn('world', self.refuse('worldless'))

    def test_says_that_the_world_has_no_route(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'bare.world.yaml'
            path.write_text('map: x.yaml\ndescription: x\nstart: [0, 0, 0]\n', encoding='utf-8')
            said = self.refuse('routeless', f'_world:={path}')
        self.assertIn(str(path), said)
        self.assertIn('no route', said)


if __name__ == '__main__':
    import rostest
    rospy.init_node('route_follower_test')
    rostest.rosrun('omega_slam', 'route_follower', RouteFollowerTest)
