#!/usr/bin/env python3
"""A recorded run, replayed by rosbag through the nodes, gives its map and its trajectory again.

Not bit by bit: over topics, a loop is found a keyframe sooner or later. The bounds say how much that
may matter; they come from runs of scripts/replay_bounds, whose table stands in docs/demo.md.
"""
import dataclasses
import pathlib
import sys
import tempfile
import unittest

import rospy
import rostest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import replay_support  # noqa: E402  (it lies beside this file, wherever that is)

# Mean + 4 sigma of 12 runs of scripts/replay_bounds, rounded up (2 processors shared with compilers).
BOUNDS = replay_support.Difference(mean_distance=0.0105, max_distance=0.032, mean_turn=0.0020,
                                   map_mismatch=0.035, map_area=0.022)

class ReplayTest(unittest.TestCase):

    def testAReplayGivesTheRecordingAgain(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            difference = replay_support.recordAndReplay(replay_support.Run(), folder)
            for run in ('recording', 'replay'):
                refused = replay_support.rejections(folder / run / 'results')
                self.assertEqual(refused, {}, f'the {run} was too fast, or good data was refused')
        for field in dataclasses.fields(difference):
            self.assertLessEqual(getattr(difference, field.name), getattr(BOUNDS, field.name),
                                 f'{field.name}: {difference}')


if __name__ == '__main__':
    rospy.init_node('replay_test')
    rostest.rosrun('omega_slam', 'replay_test', '__main__')
