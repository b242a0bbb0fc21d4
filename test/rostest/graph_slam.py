#!/usr/bin/env python3
"""graph_slam: the solved graph and map -> odom from keyframes and constraints, whatever their order."""
import itertools
import math
import pathlib
import sys

import rospy
import rostest
from nav_msgs.msg import Path
from omega_slam.msg import Constraint, ConstraintArray, Keyframe, PoseGraph
from omega_slam.srv import SaveGraph
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest, waitUntil  # noqa: E402  (it lies beside this file)
from synthetic import (Pose, constraint, constraints, keyframe, stamp, yawOf)  # noqa: E402

NAME = 'graph_slam'
RUN = 11
STEP = Pose(1.0, 0.0, math.pi / 2.0)  # along the sides of a square
ODOMETRY = Pose(1.2, 0.1, math.pi / 2.0)  # what the odometry makes of it


def power(step, count):
    pose = Pose()
    for _ in range(count):
        pose = pose * step
    return pose


class GraphSlamTest(NodeTest):

    def start(self, parameters=None):
        self.node = self.startNode(NAME, parameters)
        self.graphs = self.listen('pose_graph', PoseGraph)
        self.tf = self.listen('tf', TFMessage)
        self.keyframes = self.advertise('keyframe', Keyframe)
        self.constraints = self.advertise('constraints', ConstraintArray)
        self.connect(self.graphs, self.tf, self.keyframes, self.constraints)

    def sendKeyframe(self, number, run=RUN):
        self.keyframes.publish(keyframe(run, number, number, power(ODOMETRY, number)))

    def sendConstraint(self, number, run=RUN):
        """From the keyframe before to keyframe `number`."""
        self.constraints.publish(constraints(run, number, constraint(number - 1, number, STEP)))

    def graphOf(self, size, run=RUN):
        return self.graphs.waitFor(lambda m: len(m.poses) == size and m.run == run,
                                   f'a graph of {size} keyframes of run {run}')

    def build(self, size, run=RUN):
        self.sendKeyframe(0, run)
        for number in range(1, size):
            self.sendConstraint(number, run)
            self.sendKeyframe(number, run)
        return self.graphOf(size, run)

    def transforms(self):
        return [t for message in self.tf.messages() for t in message.transforms]

    def assertPoses(self, graph, expected, delta=1e-6):
        for message, pose in zip(graph.poses, expected):
            self.assertLess(Pose.of(message).distance(pose), delta, graph)

    def testTheGraphIsSolvedAndLatched(self):
        self.start({'map_frame': 'world'})
        self.build(4)
        late = self.listen('pose_graph', PoseGraph).waitFor()
        self.assertEqual(late.header.frame_id, 'world')
        self.assertEqual(late.header.stamp, stamp(3))
        self.assertEqual(late.stamps, [stamp(i) for i in range(4)])
        self.assertEqual((late.run, len(late.constraints)), (RUN, 3))
        self.assertPoses(late, [power(STEP, i) for i in range(4)])
        path = self.listen('trajectory', Path).waitFor()
        self.assertEqual(path.header.frame_id, 'world')
        self.assertEqual([p.header.stamp for p in path.poses], late.stamps)
        self.assertAlmostEqual(path.poses[1].pose.position.x, 1.0)
        self.assertAlmostEqual(yawOf(path.poses[1].pose.orientation), math.pi / 2.0)
        markers = self.listen('pose_graph_markers', MarkerArray).waitFor().markers
        points = {marker.ns: len(marker.points) for marker in markers}
        self.assertEqual(points, {'keyframes': 4, 'odometry': 0, 'matches': 6, 'loops': 0})
        self.assertEqual(len({(m.color.r, m.color.g, m.color.b) for m in markers}), 4)
        self.assertEqual(self.node.stop(), 0)

    def testALoopMovesTheKeyframesBetween(self):
        self.start()
        self.build(5)
        self.sendLoop()
        self.assertLoopIsSolved()

    def testALoopThatComesFirstMovesThemToo(self):
        self.start()
        self.sendLoop()  # as a node may get it that is sent a whole run at once
        self.build(5)
        self.assertLoopIsSolved()

    def sendLoop(self):
        """Keyframe 4 came home, all but 0.4 m."""
        loop = constraint(0, 4, Pose(0.0, 0.4, 0.0), Constraint.LOOP)
        self.constraints.publish(constraints(RUN, 4, loop))

    def assertLoopIsSolved(self):
        graph = self.graphs.waitFor(lambda m: len(m.constraints) == 5, 'a graph with a loop')
        self.waitForDiagnostic('graph_slam: health', 'constraints', 5)
        self.assertIn('last update [ms]', self.diagnosticValues('graph_slam: health'))
        home = Pose.of(graph.poses[4])
        self.assertGreater(home.y, 0.05)
        self.assertLess(home.y, 0.4)
        self.assertGreater(graph.chi_square, 0.0)
        self.assertEqual(graph.weights[:4], (1.0,) * 4)
        loop = graph.constraints[4]
        self.assertEqual((loop.from_id, loop.to_id, loop.kind), (0, 4, Constraint.LOOP))
        self.assertGreater(graph.weights[4], 0.0)
        self.assertEqual(graph.withdrawn, [])
        self.assertLess(Pose.of(graph.poses[0]).distance(Pose()), 1e-9)

    def testKeyframesAndConstraintsMayComeInAnyOrderAndTwice(self):
        self.start()
        for number in (3, 1, 2):
            self.sendConstraint(number)
            self.sendConstraint(number)
        for number in (0, 2, 3, 1, 2):  # 0 begins the run
            self.sendKeyframe(number)
        graph = self.graphOf(4)
        self.assertEqual(len(graph.constraints), 3)
        self.assertPoses(graph, [power(STEP, i) for i in range(4)])
        self.waitForDiagnostic('graph_slam: health', 'keyframes waiting', 0)

    def testAKeyframeWithoutConstraintsWaits(self):
        self.start()
        self.build(2)
        self.sendKeyframe(2)
        self.waitForDiagnostic('graph_slam: health', 'keyframes waiting', 1)
        self.sendConstraint(2)
        self.graphOf(3)

    def testOnlyMapToOdomIsBroadcastAndOnlyAfterAKeyframe(self):
        self.start({'transform_rate': 50.0, 'transform_tolerance': 0.25})
        self.assertNothingElse(self.tf, 0)
        self.build(2)
        self.tf.clear()
        before = rospy.Time.now()
        self.tf.waitForCount(20)
        transforms = self.transforms()
        self.assertEqual({(t.header.frame_id, t.child_frame_id) for t in transforms},
                         {('map', 'odom')})
        stamps = [t.header.stamp for t in transforms]
        self.assertEqual(stamps, sorted(set(stamps)))
        self.assertGreater(stamps[1], before + rospy.Duration(0.2))
        expected = STEP * ODOMETRY.inverse()
        self.assertAlmostEqual(transforms[-1].transform.translation.x, expected.x)
        self.assertAlmostEqual(transforms[-1].transform.translation.y, expected.y)
        self.assertAlmostEqual(yawOf(transforms[-1].transform.rotation), expected.theta)

    def testKeyframesOfAnUnknownRunAreRefused(self):
        self.start()
        self.sendKeyframe(3, run=5)
        self.waitForRejections(NAME, 'keyframe of another run', 1)
        self.build(2)
        self.sendKeyframe(2, run=5)
        self.sendConstraint(2, run=5)
        self.waitForRejections(NAME, 'keyframe of another run', 2)
        self.assertEqual(len(self.graphs.messages()[-1].poses), 2)

    def testKeyframeZeroOfAnotherRunBeginsAnew(self):
        self.start()
        self.build(3)
        self.build(2, run=RUN + 1)
        self.assertEqual(len(self.graphs.messages()[-1].poses), 2)
        self.node.waitUntilItSays('the graph begins anew')

    def testFaultyKeyframesAndConstraintsAreRefusedAndCounted(self):
        self.start()
        self.build(2)
        torn = keyframe(RUN, 2, 2)
        torn.y = torn.y[:-1]
        self.keyframes.publish(torn)
        self.waitForRejections(NAME, 'keyframe lists differ in length', 1)
        lopsided = constraint(0, 1, STEP)
        lopsided.information = [1.0, 5.0, 0.0, -5.0, 1.0, 0.0, 0.0, 0.0, 1.0]
        strange = constraint(0, 1, STEP)
        strange.kind = 77
        doubtful = constraint(0, 1, STEP)
        doubtful.confidence = math.nan
        self.constraints.publish(constraints(
            RUN, 1, constraint(0, 1, Pose(math.nan, 0.0, 0.0), Constraint.LOOP), lopsided, strange,
            doubtful, constraint(1, 1, STEP)))
        for cause in ("constraint's pose is not finite",
                      "constraint's information is not finite, symmetric and positive",
                      'constraint is of unknown kind',
                      "constraint's confidence is not within 0 and 1",
                      'constraint ties a node to itself'):
            self.waitForRejections(NAME, cause, 1)
        self.assertEqual(len(self.graphs.messages()[-1].constraints), 1)

    def testSavingAnswersTruthfully(self):
        self.start()
        rospy.wait_for_service('graph_slam/save_graph', timeout=20.0)
        save = rospy.ServiceProxy('graph_slam/save_graph', SaveGraph)
        path = self.folder() / 'deep' / 'graph.g2o'
        refused = save(str(path))
        self.assertFalse(refused.success)
        self.assertIn('no keyframe', refused.message)
        self.build(3)
        saved = save(str(path))
        self.assertTrue(saved.success, saved.message)
        self.assertEqual(saved.paths, [str(path)])
        lines = path.read_text().splitlines()
        self.assertEqual(sum(line.startswith('VERTEX_SE2') for line in lines), 3)
        self.assertEqual(sum(line.startswith('EDGE_SE2') for line in lines), 2)
        failed = save('/proc/no/graph.g2o')
        self.assertFalse(failed.success)
        self.assertIn('/proc/no', failed.message)
        self.assertEqual(failed.paths, [])

    def testResetForgetsTheGraphAndRefusesItsRun(self):
        self.start()
        self.build(3)
        rospy.wait_for_service('graph_slam/reset', timeout=20.0)
        answer = rospy.ServiceProxy('graph_slam/reset', Trigger)()
        self.assertTrue(answer.success)
        self.assertIn('3 keyframes', answer.message)
        self.graphOf(0)
        self.sendKeyframe(0)
        self.waitForRejections(NAME, 'keyframe of another run', 1)
        self.tf.clear()
        self.assertNothingElse(self.tf, 0)
        self.build(2, run=RUN + 1)
        self.tf.waitFor()

    def runClock(self, clock, begin, condition, what):
        """Lets simulated time run from `begin`, each tick given twice, until the condition is met."""
        ticks = itertools.count()

        def tickAndAsk():
            now = stamp(begin + 0.05 * next(ticks))
            clock.publish(Clock(now))
            clock.publish(Clock(now))
            return condition()

        waitUntil(tickAndAsk, what)

    def testSimulatedTimeMayStandStillAndJumpBack(self):
        rospy.set_param('/use_sim_time', True)
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        clock = self.advertise('clock', Clock)
        self.start({'transform_rate': 10.0})
        self.connect(clock)
        self.build(2)
        self.assertNothingElse(self.tf, 0)  # it is no time yet
        self.runClock(clock, 1.0, lambda: len(self.tf.messages()) > 3, 'transforms')
        count = len(self.tf.messages())
        self.assertNothingElse(self.tf, count)  # time stands still
        self.assertStampsDiffer()
        self.runClock(clock, -500.0, lambda: 'Time jumped back' in self.node.said(), 'a jump')
        ticks = itertools.count()
        self.runClock(clock, -400.0, lambda: next(ticks) > 100, 'a hundred ticks')
        self.assertEqual(len(self.tf.messages()), count)  # the graph is of a time still to come
        self.keyframes.publish(keyframe(RUN + 1, 0, -399.0))
        self.graphOf(1, RUN + 1)
        self.runClock(clock, -300.0, lambda: len(self.tf.messages()) > count + 1, 'transforms')
        self.assertStampsDiffer()

    def assertStampsDiffer(self):
        stamps = [t.header.stamp for t in self.transforms()]
        self.assertEqual(len(stamps), len(set(stamps)))

    def testBadParametersStopTheNode(self):
        self.checkBadParameters(NAME, [
            ({'transform_tolerence': 0.1}, ['graph_slam/transform_tolerence',
                                            'transform_tolerance']),
            ({'solver': {'max_iterations': 2.6}}, ['solver/max_iterations']),
            ({'transform_rate': 0.0}, ['transform_rate']),
            ({'map_frame': '/map'}, ['map_frame']),
        ])

    def testNothingIsPublishedBeforeAKeyframe(self):
        self.start()
        waitUntil(lambda: self.diagnosticValues('graph_slam: input').get('accepted') == '0',
                  'a count of nothing')
        self.assertNothingElse(self.graphs, 0)


if __name__ == '__main__':
    rospy.init_node('graph_slam_test')
    rostest.rosrun('omega_slam', 'graph_slam_test', GraphSlamTest)
