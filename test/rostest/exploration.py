#!/usr/bin/env python3
"""A whole exploration, from an unknown start until nothing is left, by the nodes as they are shipped."""
import math
import pathlib
import sys

import rospy
import rostest
from nav_msgs.msg import OccupancyGrid, Odometry
from omega_slam.msg import ExplorationStatus

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest  # noqa: E402  (it lies beside this file)

PATIENCE = 180.0  # [s]
START = (0.8, 0.8)  # [m] in the world
FLOOR = 2.45 * 3.0 + 2.45 * 3.0  # [m^2] of both rooms, about


class ExplorationTest(NodeTest):

    def testTwoRoomsAreExploredAndTheRobotComesHome(self):
        status = self.listen('exploration_status', ExplorationStatus)
        truth = self.listen('base_pose_ground_truth', Odometry)
        maps = self.listen('map', OccupancyGrid)
        ended = status.waitFor(lambda m: m.phase == 'ended', 'the end', PATIENCE)
        self.assertEqual(ended.ending, 'done', ended.reason)
        self.assertIn('home', ended.reason)
        self.assertGreater(ended.share, 0.95)
        position = truth.messages()[-1].pose.pose.position
        self.assertLess(math.hypot(position.x - START[0], position.y - START[1]), 0.5)
        newest = maps.messages()[-1]
        free = sum(value == 0 for value in newest.data) * newest.info.resolution ** 2
        self.assertGreater(free, 0.93 * FLOOR)


if __name__ == '__main__':
    rospy.init_node('exploration_test')
    rostest.rosrun('omega_slam', 'exploration_test', ExplorationTest)
