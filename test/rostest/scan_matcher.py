#!/usr/bin/env python3
"""scan_matcher: keyframes and constraints from scans; faulty scans refused; runs that begin anew."""
import math
import pathlib
import re
import sys

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from omega_slam.msg import Constraint, ConstraintArray, Keyframe, PoseGraph
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest, waitUntil  # noqa: E402  (it lies beside this file)
import synthetic  # noqa: E402
from synthetic import Pose, chain, poseGraph, roomScan, scan, stamp  # noqa: E402

NAME = 'scan_matcher'
MOUNT = Pose(0.1, 0.02, 0.3)
STEP = Pose(0.5, 0.0, 0.1)  # between two keyframes
SCALE = 1.1  # what the odometry makes of a metre


def truePose(number):
    pose = Pose()
    for _ in range(number):
        pose = pose * STEP
    return pose


def measuredPose(number):
    """As the odometry has it: every step too long."""
    pose = Pose()
    for _ in range(number):
        pose = pose * Pose(SCALE * STEP.x, STEP.y, STEP.theta)
    return pose


class ScanMatcherTest(NodeTest):

    variance = 0.01  # [m^2] of a prediction's place

    def start(self, parameters=None):
        self.node = self.startNode(NAME, parameters)
        self.keyframes = self.listen('keyframe', Keyframe)
        self.constraints = self.listen('constraints', ConstraintArray)
        self.scans = self.advertise('scan', LaserScan)
        self.predictions = self.advertise('motion/prediction', PoseWithCovarianceStamped)
        self.graphs = self.advertise('pose_graph', PoseGraph)
        self.tf = self.advertise('tf_static', TFMessage, latch=True)
        self.connect(self.keyframes, self.constraints, self.scans, self.predictions, self.graphs,
                     self.tf)

    def mountLaser(self, frame='laser', roll=0.0):
        self.tf.publish(synthetic.transform('base_footprint', frame, MOUNT, roll))

    def predict(self, seconds, pose=Pose()):
        message = PoseWithCovarianceStamped()
        odometry = synthetic.odometry(seconds, pose)
        message.header = odometry.header
        message.pose = odometry.pose
        covariance = [0.0] * 36
        covariance[0] = covariance[7] = self.variance
        covariance[35] = 0.001
        message.pose.covariance = covariance
        self.predictions.publish(message)

    def goTo(self, number, begin=0.0, **kwargs):
        """To the place of keyframe `number`, where a scan is taken at `begin + number` seconds."""
        self.scans.publish(roomScan(begin + number, truePose(number) * MOUNT, **kwargs))
        self.predict(begin + number, measuredPose(number))

    def keyframe(self, number, seconds):
        return self.keyframes.waitFor(
            lambda m: m.id == number and m.header.stamp == stamp(seconds), f'keyframe {number}')

    def drive(self, count, begin=0.0, first=0):
        """Makes keyframes `first` to count - 1 and returns them."""
        keyframes = []
        for number in range(first, count):
            self.goTo(number, begin)
            keyframes.append(self.keyframe(number, begin + number))
        return keyframes

    def testScansBecomeKeyframesAndConstraints(self):
        self.start()
        self.mountLaser()
        keyframes = self.drive(4)
        self.assertEqual([k.id for k in keyframes], [0, 1, 2, 3])
        self.assertEqual({k.run for k in keyframes}, {keyframes[0].run})
        self.assertEqual({k.header.frame_id for k in keyframes}, {'base_footprint'})
        for number, keyframe in enumerate(keyframes):
            self.assertLess(Pose.of(keyframe.odometry).distance(measuredPose(number)), 1e-6)
            self.assertEqual(len(keyframe.x), 360)
            self.assertAlmostEqual(keyframe.laser.x, MOUNT.x)
        arrays = self.constraints.waitForCount(3)
        for number, array in enumerate(arrays[:3]):
            self.assertEqual(array.header.stamp, stamp(number + 1))
            self.assertEqual(array.run, keyframes[0].run)
            self.checkConstraints(array.constraints, number)
        self.waitForDiagnostic('scan_matcher: input', 'accepted', 4)
        self.assertEqual(self.node.stop(), 0)

    def testWhatIsAlwaysWrongWithTheOdometryIsSaid(self):
        self.variance = 4e-4
        self.start()
        self.mountLaser()
        self.drive(1)
        self.waitForDiagnostic('scan_matcher: health', 'faults of the odometry', 'none')
        self.drive(12, first=1)

        def said():
            return self.diagnosticValues('scan_matcher: health').get('faults of the odometry', '')
        waitUntil(lambda: re.match(r'ways are \d+\.\d % shorter', said()), said)

    def checkConstraints(self, constraints, number):
        """From keyframe `number` and the one before it to the next; a match is nearer to the truth by far."""
        self.assertEqual({c.from_id for c in constraints}, {number, max(number - 1, 0)})
        self.assertEqual({c.to_id for c in constraints}, {number + 1})
        self.assertEqual({c.kind for c in constraints}, {Constraint.ODOMETRY, Constraint.MATCH})
        for constraint in (c for c in constraints if c.from_id == number):
            distance = Pose.of(constraint.pose).distance(STEP)
            if constraint.kind == Constraint.ODOMETRY:
                self.assertGreater(distance, 0.03)
            else:
                self.assertLess(distance, 0.015)

    def testALateSubscriberGetsTheWholeRun(self):
        self.start()
        self.mountLaser()
        self.drive(3)
        # Within one process subscribers share a connection: the first must go for a new one.
        self.keyframes.close()
        self.constraints.close()
        late = self.listen('keyframe', Keyframe)
        self.assertEqual([k.id for k in late.waitForCount(3)], [0, 1, 2])
        constraints = self.listen('constraints', ConstraintArray).waitForCount(2)
        self.assertEqual([c.header.stamp for c in constraints], [stamp(1), stamp(2)])

    def testWithoutTfNothingIsPublishedAndBothFramesAreNamed(self):
        self.start({'odometry_wait': 0.9})
        for number in range(3):
            self.goTo(number)
        self.waitForRejections(NAME, 'no usable pose of the laser', 2)
        self.assertIn("from frame 'laser' to frame 'base_footprint'", self.node.said())
        self.assertIn('1000.000000', self.node.said())
        self.assertNothingElse(self.keyframes, 0)
        self.mountLaser()
        self.goTo(3)
        self.keyframe(0, 2.0)  # it still waited when tf came

    def testAParameterCanStandInForTf(self):
        self.start({'laser_pose': [0.1, 0.02, 0.3]})
        keyframe = self.drive(1)[0]
        self.assertAlmostEqual(keyframe.laser.y, 0.02)
        self.assertAlmostEqual(keyframe.laser.theta, 0.3)

    def testALeadingSlashInTheFrameIsNoObstacle(self):
        self.start()
        self.mountLaser()
        self.goTo(0, frame='/laser')
        self.keyframe(0, 0.0)

    def testALaserUpsideDownSeesTheSameRoom(self):
        self.start()
        self.mountLaser()
        self.goTo(0)
        self.keyframe(0, 0.0)
        self.mountLaser('turned_over', math.pi)
        turned_over = roomScan(1.0, truePose(1) * MOUNT, frame='turned_over')
        turned_over.ranges = [turned_over.ranges[-i] for i in range(360)]  # beam i looks at -angle i
        self.scans.publish(turned_over)
        self.predict(1.0, measuredPose(1))
        self.keyframe(1, 1.0)
        self.checkConstraints(self.constraints.waitForCount(1)[0].constraints, 0)

    def testATiltedLaserIsRefused(self):
        self.start({'odometry_wait': 0.1})
        self.mountLaser(roll=0.3)
        self.goTo(0)
        self.predict(1.0)
        self.waitForRejections(NAME, 'no usable pose of the laser', 1)
        self.assertIn('tilts the laser by 0.300 rad', self.node.said())
        self.assertNothingElse(self.keyframes, 0)

    def testScansOfAnyCountOfBeamsAreTaken(self):
        self.start()
        self.mountLaser()
        for number, beams in enumerate((360, 181, 720)):
            self.goTo(number, beams=beams)
            self.assertEqual(len(self.keyframe(number, float(number)).x), beams)
        self.checkConstraints(self.constraints.waitForCount(2)[0].constraints, 0)

    def testAllAroundNothingIsATrueAnswerWhereInfinityMeansFree(self):
        self.start({'scans': {'no_return_range': 3.0}})
        self.mountLaser()
        self.scans.publish(scan(0.0, [math.inf] * 360))
        self.predict(0.0)
        keyframe = self.keyframe(0, 0.0)
        self.assertEqual(set(keyframe.kind), {Keyframe.NO_RETURN})
        self.goTo(1)  # nothing to match with: the odometry stands alone
        self.keyframe(1, 1.0)
        kinds = [c.kind for c in self.constraints.waitForCount(1)[0].constraints]
        self.assertEqual(kinds, [Constraint.ODOMETRY])
        self.waitForDiagnostic('scan_matcher: health', 'matches not trusted', 1)

    def testScansThatSayNothingAreRefusedAndCounted(self):
        self.start({'scans': {'no_return_range': 0.0}})
        self.mountLaser()
        self.goTo(0)
        self.keyframe(0, 0.0)
        faulty = [[math.nan] * 360, [math.inf] * 360, [-math.inf] * 360, []]
        for i, ranges in enumerate(faulty):
            self.scans.publish(scan(0.1 * (i + 1), ranges))
        no_step = scan(0.5, [1.0] * 360)
        no_step.angle_increment = math.nan
        self.scans.publish(no_step)
        self.predict(0.6)
        self.waitForRejections(NAME, 'no beam says anything', 3)
        self.waitForRejections(NAME, 'no beams', 1)
        self.waitForRejections(NAME, 'angles are not finite', 1)
        self.goTo(1)
        self.keyframe(1, 1.0)
        self.waitForDiagnostic('scan_matcher: input', 'accepted', 2)

    def testScansOutOfOrderAreRefusedAndCounted(self):
        self.start()
        self.mountLaser()
        self.predict(-1.0)
        self.drive(2)
        self.scans.publish(roomScan(1.0, MOUNT))
        self.scans.publish(roomScan(0.5, MOUNT))
        self.waitForRejections(NAME, 'scan is not newer than the one before', 2)
        self.assertNothingElse(self.keyframes, 2)

    def testAScanWaitsForItsOdometryAndNoLonger(self):
        self.start({'odometry_wait': 0.3})
        self.mountLaser()
        self.predict(-1.0)
        self.goTo(0)
        self.keyframe(0, 0.0)
        self.scans.publish(roomScan(1.0, truePose(1) * MOUNT))  # before its odometry
        self.predict(1.0, measuredPose(1))
        self.keyframe(1, 1.0)
        self.scans.publish(roomScan(2.0, truePose(2) * MOUNT))
        self.scans.publish(roomScan(3.0, truePose(2) * MOUNT))
        self.waitForRejections(NAME, 'no odometry for the scan', 1)
        self.assertIn('motion/prediction', self.node.said())
        self.assertNothingElse(self.keyframes, 2)

    def testSweepsAreFreedOfTheMotionDuringThem(self):
        self.start({'scans': {'max_range': 20.0}})
        self.tf.publish(synthetic.transform('base_footprint', 'laser', Pose()))
        # The robot drives 1 m/s at a wall 5 m ahead; the last beam looks ahead, 1 s after the first.
        sweep = scan(0.0, [5.0, 4.0], field_of_view=0.02)
        sweep.time_increment = 1.0
        sweep.angle_min, sweep.angle_increment = 0.0, 0.01
        self.scans.publish(sweep)
        self.predict(0.0)
        self.predict(1.0, Pose(1.0, 0.0, 0.0))
        keyframe = self.keyframe(0, 0.5)  # seen from halfway
        self.assertAlmostEqual(keyframe.odometry.x, 0.5, places=3)
        self.assertAlmostEqual(keyframe.x[0], 4.5, places=3)
        self.assertAlmostEqual(keyframe.x[1], 0.5 + 4.0 * math.cos(0.01), places=3)

    def testTimeJumpingBackBeginsANewRun(self):
        self.start()
        self.mountLaser()
        first = self.drive(2, begin=100.0)
        self.keyframes.clear()
        self.predict(-0.5)
        self.node.waitUntilItSays('Time jumped back')
        second = self.drive(2)
        self.assertEqual([k.id for k in second], [0, 1])
        self.assertNotEqual(second[0].run, first[0].run)

    def testAnEmptyGraphOfTheRunBeginsANewOne(self):
        self.start()
        self.mountLaser()
        run = self.drive(2)[0].run
        self.graphs.publish(poseGraph(run + 1, []))
        self.waitForRejections(NAME, 'pose graph of another run', 1)
        bent = poseGraph(run, [Pose(math.nan, 0.0, 0.0)])
        self.graphs.publish(bent)
        self.waitForRejections(NAME, 'pose graph has numbers that are not finite', 1)
        self.graphs.publish(poseGraph(run, []))
        self.node.waitUntilItSays('A new run begins')
        self.goTo(2)
        self.assertNotEqual(self.keyframe(0, 2.0).run, run)

    def testLoopsAreFoundWhereTheGraphSaysThatPlacesAreNear(self):
        self.start({'loops': {'min_separation': 3, 'search_radius': 2.0}})
        self.mountLaser()
        run = self.drive(5)[0].run
        self.graphs.publish(chain(run, [truePose(i) for i in range(5)]))
        loops = self.constraints.waitFor(
            lambda m: m.constraints and m.constraints[0].kind == Constraint.LOOP, 'a loop')
        loop = loops.constraints[0]
        self.assertEqual(loops.run, run)
        newest = max(loop.from_id, loop.to_id)
        self.assertEqual(loops.header.stamp, stamp(newest))
        truth = truePose(loop.from_id).inverse() * truePose(loop.to_id)
        self.assertLess(Pose.of(loop.pose).distance(truth), 0.03)
        self.waitForDiagnostic('scan_matcher: health', 'keyframes searched for loops', 5)

    def testALostRobotSaysSoAndIsFound(self):
        self.start()
        self.mountLaser()
        lost = self.listen('lost', Bool)
        self.assertFalse(lost.waitForCount(1)[0].data)
        run = self.drive(3)[0].run
        self.graphs.publish(chain(run, [truePose(i) for i in range(3)]))
        closet = synthetic.Room(left=-0.4, right=0.6, bottom=-0.5, top=0.4, pillar=(0.4, 0.2, 0.05))
        for second in range(3, 12):  # something stands around the robot, which turns a little
            wheels = measuredPose(2) * Pose(0.0, 0.0, 0.01 * second)
            self.scans.publish(roomScan(second, Pose(0.0, 0.0, 0.01 * second), room=closet))
            self.predict(second, wheels)
        lost.waitFor(lambda m: m.data, 'lost')
        self.waitForDiagnostic('scan_matcher: input', 'accepted', 12)
        self.waitForHealth(NAME, DiagnosticStatus.ERROR, 'lost')
        self.assertNothingElse(self.keyframes, 3)
        carried = Pose(1.5, 0.3, 2.0)  # and is set down, and looks around
        turned = 0.35  # [rad] from scan to scan
        for step in range(20):
            motion = Pose(0.0, 0.0, turned * step)
            self.scans.publish(roomScan(12 + step, carried * motion * MOUNT))
            self.predict(12 + step, measuredPose(2) * motion)
        found = self.keyframes.waitFor(lambda m: m.id == 3, 'a keyframe where it was found')
        tie = self.constraints.waitFor(
            lambda m: any(c.to_id == 3 for c in m.constraints), 'its tie').constraints[0]
        self.assertEqual(tie.kind, Constraint.MATCH)
        steps = found.header.stamp.to_sec() - stamp(12).to_sec()
        truth = carried * Pose(0.0, 0.0, turned * steps)
        self.assertLess((truePose(tie.from_id) * Pose.of(tie.pose)).distance(truth), 0.05)
        self.assertFalse(lost.waitForCount(3)[2].data)

    def testALaserThatRepeatsItselfIsNotBelieved(self):
        self.start()
        self.mountLaser()
        self.drive(2)
        for second in (2, 3):
            self.scans.publish(roomScan(second, truePose(1) * MOUNT))
            self.predict(second, measuredPose(second))
        self.waitForRejections(NAME, 'scan repeats the one before', 2)
        self.assertNothingElse(self.keyframes, 2)

    def testBadParametersStopTheNode(self):
        self.checkBadParameters(NAME, [
            ({'keyframe_translatoin': 0.3}, ['scan_matcher/keyframe_translatoin',
                                             'keyframe_translation']),
            ({'loops': {'max_window': {'translatoin': 3}}},
             ['loops/max_window/translatoin', 'translation']),
            ({'matcher': 'ipc'}, ['scan_matcher/matcher', 'icp']),
            ({'min_confidence': '0.5'}, ['scan_matcher/min_confidence']),
            ({'laser_pose': [1.0]}, ['laser_pose']),
            ({'odometry_wait': -1.0}, ['odometry_wait']),
        ])


if __name__ == '__main__':
    rospy.init_node('scan_matcher_test')
    rostest.rosrun('omega_slam', 'scan_matcher_test', ScanMatcherTest)
