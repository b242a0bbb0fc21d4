#!/usr/bin/env python3
"""run_recorder against a made-up run: when it ends, what it saves, what it says."""
import json
import math
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

import roslib.packages
import rospkg
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry
from omega_slam.msg import Constraint, Keyframe, Pose2, PoseGraph, Tracking
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

PACKAGE = 'omega_slam'
WORLD = pathlib.Path(rospkg.RosPack().get_path(PACKAGE)) / 'maps' / 'lab.world.yaml'
RESULTS = {'map.pgm', 'map.yaml', 'map.png', 'trajectory.tum', 'graph.g2o', 'report.md',
           'report.json', 'timing.json'}
UNSETTLED = 'The map was saved before it had caught up with the newest scans.'
SECONDS = 12  # a scan each, a keyframe every fourth of them
ROSLAUNCH_GRACE = 15.0  # [s] between roslaunch's SIGINT and its SIGTERM
DRIFT = 1.05  # what the odometry makes of a metre


def odometry(stamp, x, frame):
    message = Odometry()
    message.header.stamp = rospy.Time.from_sec(stamp)
    message.header.frame_id = frame
    message.child_frame_id = 'base_footprint'
    message.pose.pose.position.x = x
    message.pose.pose.orientation.w = 1.0
    return message


class FakeRun:
    """A robot that drives 1 m/s along x from (2, 0) in the world; SLAM knows the truth."""

    def __init__(self):
        self.publishers = {
            'odom': rospy.Publisher('odom', Odometry, queue_size=100),
            'truth': rospy.Publisher('base_pose_ground_truth', Odometry, queue_size=100),
            'scan': rospy.Publisher('scan', LaserScan, queue_size=100),
            'tracking': rospy.Publisher('tracking', Tracking, queue_size=100),
            'keyframe': rospy.Publisher('keyframe', Keyframe, queue_size=100),
            'graph': rospy.Publisher('pose_graph', PoseGraph, queue_size=100),
            'map': rospy.Publisher('map', OccupancyGrid, queue_size=100),
            'route': rospy.Publisher('route_status', String, queue_size=10, latch=True),
            'tf': rospy.Publisher('tf', TFMessage, queue_size=100),
        }
        self.route('driving 1/3')

    def close(self):
        """Forgets who listened and what was latched: the next case begins with neither."""
        for publisher in self.publishers.values():
            publisher.unregister()

    def waitForRecorder(self):
        deadline = time.monotonic() + 20.0
        while any(p.get_num_connections() == 0 for p in self.publishers.values()):
            if time.monotonic() > deadline:
                raise RuntimeError('run_recorder does not listen to: ' + ', '.join(
                    name for name, p in self.publishers.items() if p.get_num_connections() == 0))
            time.sleep(0.05)

    def route(self, text):
        self.publishers['route'].publish(String(text))

    def drive(self, first, last):
        for second in range(first, last + 1):
            self.publishers['truth'].publish(odometry(second, 2.0 + second, 'world'))
            self.publishers['odom'].publish(odometry(second, DRIFT * second, 'odom'))
            scan = LaserScan()
            scan.header.stamp = rospy.Time.from_sec(second)
            self.publishers['scan'].publish(scan)
            self.track(second)
            if second % 4 == 0:
                keyframe = Keyframe(id=second // 4)
                keyframe.header.stamp = scan.header.stamp
                self.publishers['keyframe'].publish(keyframe)

    def track(self, second):
        before = max(second - 1, 0) // 4  # keyframe
        tracking = Tracking(keyframe_id=before, pose=Pose2(second - 4.0 * before, 0.0, 0.0),
                            is_keyframe=second % 4 == 0)
        tracking.header.stamp = rospy.Time.from_sec(second)
        self.publishers['tracking'].publish(tracking)

    def publishTf(self, stamp):
        """The tracked pose 0.3 m ahead of the truth."""
        def transform(parent, child, x):
            result = TransformStamped()
            result.header.stamp = rospy.Time.from_sec(stamp)
            result.header.frame_id, result.child_frame_id = parent, child
            result.transform.translation.x = x
            result.transform.rotation.w = 1.0
            return result
        self.publishers['tf'].publish(TFMessage([
            transform('map', 'odom', stamp + 0.3 - DRIFT * stamp),
            transform('odom', 'base_footprint', DRIFT * stamp)]))

    def solve(self, keyframes, loops=0):
        graph = PoseGraph()
        graph.header.frame_id = 'map'
        for number in range(keyframes):
            graph.poses.append(Pose2(4.0 * number, 0.0, 0.0))
            graph.stamps.append(rospy.Time.from_sec(4.0 * number))
        graph.header.stamp = graph.stamps[-1]
        identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
        for number in range(1, keyframes):
            graph.constraints.append(Constraint(number - 1, number, Pose2(4.0, 0.0, 0.0), identity,
                                                1.0, Constraint.ODOMETRY))
        for _ in range(loops):
            graph.constraints.append(Constraint(0, keyframes - 1,
                                                Pose2(4.0 * (keyframes - 1), 0.0, 0.0), identity,
                                                0.9, Constraint.LOOP))
        graph.weights = [0.5 if c.kind == Constraint.LOOP else 1.0 for c in graph.constraints]
        graph.withdrawn = [Constraint(0, keyframes - 1, Pose2(1.0, 0.0, 0.0), identity, 0.9,
                                      Constraint.LOOP)] * loops
        self.publishers['graph'].publish(graph)

    def draw(self, stamp):
        grid = OccupancyGrid()
        grid.header.frame_id = 'map'
        grid.header.stamp = rospy.Time.from_sec(stamp)
        grid.info.resolution = 0.5
        grid.info.width, grid.info.height = 40, 8
        grid.info.origin.position.x, grid.info.origin.position.y = -2.0, -2.0
        grid.info.origin.orientation.w = 1.0
        grid.data = [0] * (40 * 4) + [100] * 40 + [-1] * (40 * 3)
        self.publishers['map'].publish(grid)


class RunRecorderTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = pathlib.Path(folder.name) / 'new' / 'results'
        self.recorder = None
        self.addCleanup(self.killRecorder)
        self.robot = FakeRun()
        self.addCleanup(self.robot.close)

    def killRecorder(self):
        if self.recorder is not None and self.recorder.poll() is None:
            self.recorder.kill()
            self.recorder.wait()

    def start(self, **parameters):
        if rospy.has_param('run_recorder'):  # of an earlier case
            rospy.delete_param('run_recorder')
        rospy.set_param('run_recorder', {'results': str(self.results), 'world': str(WORLD),
                                         'status_interval': 0.2, **parameters})
        # Not by rosrun: it does not look into folders named build.
        program = roslib.packages.find_node(PACKAGE, 'run_recorder')[0]
        self.recorder = subprocess.Popen([program], text=True, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT)

    def finish(self, patience=25.0):
        """@return (exit code, what was printed)"""
        output, _ = self.recorder.communicate(timeout=patience)
        return self.recorder.returncode, output

    def expectRunning(self, seconds=1.0):
        time.sleep(seconds)
        self.assertIsNone(self.recorder.poll(), 'run_recorder has ended too early')

    def trajectory(self):
        lines = (self.results / 'trajectory.tum').read_text().splitlines()
        return [[float(number) for number in line.split()] for line in lines]

    def report(self):
        return json.loads((self.results / 'report.json').read_text())

    def runAll(self):
        self.robot.waitForRecorder()
        self.robot.drive(0, SECONDS)
        self.robot.solve(SECONDS // 4 + 1, loops=1)
        self.robot.draw(SECONDS)
        self.robot.publishTf(SECONDS)

    def testADoneRouteIsSavedWholeOnceTheMapHasCaughtUp(self):
        self.start(settle_deadline=60.0)
        self.robot.waitForRecorder()
        self.robot.drive(0, SECONDS)
        self.robot.solve(SECONDS // 4 + 1, loops=1)
        self.robot.draw(SECONDS - 4)
        self.robot.publishTf(SECONDS)
        self.expectRunning()
        self.robot.route('done')
        self.expectRunning(0.5)  # settling is counted from the moment that the end is noticed
        self.robot.drive(SECONDS + 1, SECONDS + 3)
        self.expectRunning()
        self.robot.draw(SECONDS)
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        self.assertEqual({path.name for path in self.results.iterdir()}, RESULTS)
        self.assertRegex(output, r'4 keyframes +1 loops')
        self.assertRegex(output, r'error 0\.300 m')
        self.expectTrueTrajectory()
        self.expectGraphAndReport()

    def expectTrueTrajectory(self):
        trajectory = self.trajectory()
        self.assertEqual([pose[0] for pose in trajectory], list(range(SECONDS + 4)))
        for stamp, x, y, _, _, _, qz, qw in trajectory[:SECONDS + 1]:
            self.assertAlmostEqual(x, stamp, places=6)
            self.assertAlmostEqual(y, 0.0, places=6)
            self.assertAlmostEqual(math.hypot(qz, qw), 1.0, places=6)

    def expectGraphAndReport(self):
        graph = (self.results / 'graph.g2o').read_text()
        self.assertEqual(graph.count('VERTEX_SE2'), 4)
        self.assertEqual(graph.count('EDGE_SE2'), 4)
        report = self.report()
        self.assertIn('The run ended: route done.', report['notes'])
        self.assertNotIn(UNSETTLED, report['notes'])
        # Behind the last keyframe the odometry goes on alone, 5 % too fast, for three metres.
        self.assertLess(report['absolute_trajectory_error']['translation']['max'], 0.15)
        self.assertEqual(report['keyframes'], 4)
        self.assertEqual([loop['weight'] for loop in report['loops']], [0.5, 0.0])
        timings = json.loads((self.results / 'timing.json').read_text())['timings']
        self.assertEqual(timings['scan to keyframe']['count'], 4)
        self.assertEqual(timings['keyframe to map']['count'], 2)

    def testEndsWhenTheTimeIsUp(self):
        self.start(duration=11.5)
        self.runAll()
        self.expectRunning(0.5)
        self.robot.drive(SECONDS + 1, SECONDS + 2)
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        self.assertIn('The run ended: time is up.', self.report()['notes'])

    def testAMapThatNeverComesIsWaitedForUntilTheDeadline(self):
        self.start(settle_deadline=2.0)
        self.robot.waitForRecorder()
        self.robot.drive(0, SECONDS)
        self.robot.solve(SECONDS // 4 + 1)
        self.robot.route('stuck: bumped too often')
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        notes = self.report()['notes']
        self.assertIn('The run ended: robot stuck: bumped too often.', notes)
        self.assertIn(UNSETTLED, notes)
        self.assertFalse((self.results / 'map.pgm').exists())
        self.assertIn('There is no map', output)

    def testInterruptedBySigintItSaves(self):
        self.expectSavesOn(signal.SIGINT)

    def testInterruptedBySigtermItSaves(self):
        self.expectSavesOn(signal.SIGTERM)

    def expectSavesOn(self, number):
        self.start()
        self.runAll()
        self.expectRunning()
        self.recorder.send_signal(number)
        started = time.monotonic()
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        self.assertLess(time.monotonic() - started, ROSLAUNCH_GRACE)
        self.assertIn('The run ended: interrupted.', self.report()['notes'])
        self.assertEqual({path.name for path in self.results.iterdir()}, RESULTS)

    def testWithoutAnyMessageTheReportSaysSo(self):
        self.start()
        self.robot.waitForRecorder()
        self.recorder.send_signal(signal.SIGINT)
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        self.assertEqual(self.report()['keyframes'], 0)
        self.assertIn('There is no map', output)

    def testTimeThatJumpsBackBeginsANewRun(self):
        self.start()
        self.runAll()
        self.expectRunning(0.5)
        self.robot.drive(0, 4)
        self.robot.solve(2)
        self.robot.draw(4.0)
        self.expectRunning(0.5)
        self.recorder.send_signal(signal.SIGINT)
        code, output = self.finish()
        self.assertEqual(code, 0, output)
        self.assertIn('jumped back', output)
        # What came between the jump and the scan that told of it may be lost, and nothing else.
        stamps = [pose[0] for pose in self.trajectory()]
        self.assertEqual(stamps[-4:], [1.0, 2.0, 3.0, 4.0])
        self.assertIn(stamps[:-4], ([], [0.0]))

    def testAFolderThatCannotBeWrittenIsAnError(self):
        self.start(results='/dev/null/results')
        self.runAll()
        self.expectRunning(0.5)
        self.recorder.send_signal(signal.SIGINT)
        code, output = self.finish()
        self.assertEqual(code, 1, output)
        self.assertIn('/dev/null/results', output)

    def testBadParametersStopItWithASentence(self):
        for parameters, sentence in (({'duration': -1.0}, 'duration'),
                                     ({'duration': 'long'}, 'duration'),
                                     ({'durration': 5.0}, 'duration'),
                                     ({'results': ''}, 'must name a folder'),
                                     ({'world': '/nowhere.world.yaml'}, '/nowhere.world.yaml')):
            self.start(**parameters)
            code, output = self.finish()
            self.assertEqual(code, 1, output)
            self.assertIn('FATAL', output)
            self.assertIn(sentence, output)


if __name__ == '__main__':
    rospy.init_node('run_recorder_test')
    rostest.rosrun(PACKAGE, 'run_recorder_test', '__main__')
