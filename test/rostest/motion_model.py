#!/usr/bin/env python3
"""motion_model: predictions from odometry or tf, anchored at keyframes; faulty odometry refused."""
import math
import pathlib
import sys

import rospy
import rostest
from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped
from nav_msgs.msg import Odometry
from omega_slam.msg import Keyframe
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest, waitUntil  # noqa: E402  (it lies beside this file)
from synthetic import Pose, keyframe, odometry, stamp, transform  # noqa: E402

NAME = 'motion_model'
PLANAR = {0, 1, 5, 6, 7, 11, 30, 31, 35}  # x, y, yaw among the 36 elements
SPEED = 0.5  # [m/s] along x


class MotionModelTest(NodeTest):

    def start(self, parameters=None):
        self.node = self.startNode(NAME, parameters)
        self.predictions = self.listen('motion/prediction', PoseWithCovarianceStamped)
        self.odometry = self.advertise('odom', Odometry)
        self.keyframes = self.advertise('keyframe', Keyframe)
        self.connect(self.predictions, self.keyframes)

    def drive(self, begin, end, frame='odom'):
        """Along x at 50 Hz. Returns the prediction at the end."""
        self.connect(self.odometry)
        for i in range(round(50 * begin), round(50 * end) + 1):
            self.odometry.publish(odometry(i / 50.0, Pose(SPEED * i / 50.0, 0.0, 0.0), frame))
        return self.predictionAt(end)

    def predictionAt(self, seconds):
        return self.predictions.waitFor(lambda m: m.header.stamp == stamp(seconds),
                                        f'the prediction at {seconds}')

    def testThePredictionIsTheOdometryWithTheSpreadOfTheMotion(self):
        self.start()
        prediction = self.drive(0.0, 2.0, frame='/odom')
        self.assertEqual(prediction.header.frame_id, 'odom')
        self.assertAlmostEqual(prediction.pose.pose.position.x, 2.0 * SPEED)
        covariance = prediction.pose.covariance
        self.assertEqual({i for i, c in enumerate(covariance) if c != 0.0} - PLANAR, set())
        for i in (0, 7, 35):
            self.assertGreater(covariance[i], 0.0)
            self.assertGreater(covariance[i], self.predictionAt(1.0).pose.covariance[i])
        self.assertEqual(self.node.stop(), 0)

    def testAKeyframeAnchorsTheSpreadAtItsOwnTime(self):
        self.start()
        before = self.drive(0.0, 3.0)
        self.keyframes.publish(keyframe(7, 0, 2.0, Pose(2.0 * SPEED, 0.0, 0.0)))
        self.waitForDiagnostic('motion_model: health', 'anchored at keyframe', 0)
        after = self.drive(3.02, 3.04)
        self.assertGreater(after.pose.covariance[0], 0.0)
        self.assertLess(after.pose.covariance[0], 0.5 * before.pose.covariance[0])

    def testAKeyframeSentAgainChangesNothing(self):
        self.start()
        self.drive(0.0, 1.0)
        self.keyframes.publish(keyframe(7, 5, 1.0, Pose(SPEED, 0.0, 0.0)))
        self.keyframes.publish(keyframe(7, 3, 0.0))
        self.keyframes.publish(keyframe(8, 0, 0.0, Pose(math.nan, 0.0, 0.0)))
        self.waitForRejections(NAME, 'keyframe has numbers that are not finite', 1)
        self.waitForDiagnostic('motion_model: health', 'anchored at keyframe', 5)

    def testSamplesLieAroundThePrediction(self):
        self.start({'samples': 37, 'seed': 3})
        samples = self.listen('motion/samples', PoseArray)
        self.connect(samples)
        self.drive(0.0, 2.0)
        array = samples.waitFor(lambda m: m.header.stamp == stamp(2.0), 'samples at the end')
        self.assertEqual(array.header.frame_id, 'odom')
        self.assertEqual(len(array.poses), 37)
        mean = sum(pose.position.x for pose in array.poses) / 37.0
        self.assertAlmostEqual(mean, 2.0 * SPEED, delta=0.1)
        self.assertGreater(len({pose.position.x for pose in array.poses}), 30)

    def testFaultyOdometryIsRefusedAndCounted(self):
        self.start()
        self.drive(0.0, 1.0)
        self.odometry.publish(odometry(1.02, Pose(math.nan, 0.0, 0.0)))
        self.odometry.publish(odometry(1.02, Pose(0.0, math.inf, 0.0)))
        unturned = odometry(1.02, Pose())
        unturned.pose.pose.orientation.w = 0.0
        self.odometry.publish(unturned)
        self.odometry.publish(odometry(1.0, Pose()))
        self.odometry.publish(odometry(0.5, Pose()))
        self.waitForRejections(NAME, 'odometry is not a finite pose', 3)
        self.waitForRejections(NAME, 'odometry has the stamp of the one before', 1)
        self.waitForRejections(NAME, 'odometry out of order', 1)
        self.waitForDiagnostic('motion_model: input', 'accepted', 51)
        self.assertNothingElse(self.predictions, 51)
        self.assertEqual(self.node.said().count('odometry is not a finite pose'), 1)
        self.drive(1.02, 1.1)

    def testTimeJumpingBackBeginsAnew(self):
        self.start()
        far = self.drive(100.0, 102.0)
        fresh = self.drive(0.0, 0.0)
        self.assertGreater(far.pose.covariance[0], 0.0)
        self.assertEqual(fresh.pose.covariance[0], 0.0)
        self.node.waitUntilItSays('Time jumped back')
        self.assertIn('[ INFO]', self.node.said())

    def testTfCanBeTheSource(self):
        self.start({'odometry_source': 'tf', 'odom_frame': 'odom', 'base_frame': 'base_link',
                    'tf_rate': 100.0})
        self.node.waitUntilItSays("'base_link' to frame 'odom'")
        self.assertEqual(self.predictions.messages(), [])
        tf = self.advertise('tf', TFMessage)
        self.connect(tf)
        for i in range(2):
            tf.publish(transform('odom', 'base_link', Pose(0.1 * i, 0.0, 0.2), seconds=i))
            prediction = self.predictionAt(float(i))
        self.assertEqual(prediction.header.frame_id, 'odom')
        self.assertAlmostEqual(prediction.pose.pose.position.x, 0.1)
        self.assertNothingElse(self.predictions, 2)

    def testBadParametersStopTheNode(self):
        self.checkBadParameters(NAME, [
            ({'noise': {'rotation_per_rotatoin': 0.1}},
             ['motion_model/noise/rotation_per_rotatoin', 'rotation_per_rotation']),
            ({'tf_rate': 'fast'}, ['motion_model/tf_rate']),
            ({'noise': {'rotation_per_rotation': -1.0}}, ['rotation_per_rotation']),
            ({'odometry_source': 'wheels'}, ['odometry_source', 'topic', 'tf']),
        ])

    def testDiagnosticsComeBeforeAnyInput(self):
        self.start()
        waitUntil(lambda: self.diagnosticValues('motion_model: input').get('accepted') == '0',
                  'a count of nothing')


if __name__ == '__main__':
    rospy.init_node('motion_model_test')
    rostest.rosrun('omega_slam', 'motion_model_test', MotionModelTest)
