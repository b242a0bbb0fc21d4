#!/usr/bin/env python3
"""The launch files explain themselves and start what they say; the robot is put together right."""
import math
import pathlib
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import rospkg
import rospy
import rostest
import tf2_ros
import yaml

PACKAGE = 'omega_slam'
ROOT = pathlib.Path(rospkg.RosPack().get_path(PACKAGE))
SLAM = {'/motion_model', '/scan_matcher', '/graph_slam', '/map_builder'}
SIMULATION = {'/simulator', '/route_follower', '/robot_state_publisher'}
# What each file starts when nothing is asked of it.
EXPLORATION = {'/navigator', '/frontier_explorer'}
NODES = {
    'demo.launch': SLAM | (SIMULATION - {'/route_follower'}) | EXPLORATION | {'/run_recorder'},
    'description.launch': {'/robot_state_publisher'},
    'exploration.launch': SLAM | EXPLORATION,
    'monitor.launch': {'/rviz'},
    'navigation.launch': {'/navigator'},
    'simulation.launch': SIMULATION,
    'slam.launch': SLAM,
    'turtlebot.launch': SLAM | {'/base_to_laser'},
}
# Frames that the TurtleBot's own description and drivers have, and the parts that carry them.
LINKS = {
    'base_footprint', 'base_link', 'wheel_left_link', 'wheel_right_link', 'caster_front_link',
    'caster_back_link', 'plate_bottom_link', 'plate_middle_link', 'plate_top_link', 'laser',
    'gyro_link', 'camera_link', 'camera_rgb_frame', 'camera_rgb_optical_frame',
    'camera_depth_frame', 'camera_depth_optical_frame'
}
HOKUYO_HALF_VIEW = math.radians(120.0)


def roslaunch(*arguments):
    return subprocess.run(['roslaunch', *arguments], capture_output=True, text=True, timeout=60,
                          check=False)


def launchFiles():
    return sorted((ROOT / 'launch').glob('*.launch'))


def vector(text):
    return [float(number) for number in text.split()]


class LaunchFilesTest(unittest.TestCase):

    def testEveryFileIsExpected(self):
        self.assertEqual({path.name for path in launchFiles()}, set(NODES))

    def testEveryArgumentIsExplainedAndHasADefault(self):
        for path in launchFiles():
            for argument in ElementTree.parse(path).getroot().findall('arg'):
                where = f'{path.name}: {argument.get("name")}'
                self.assertTrue(argument.get('doc'), where)
                self.assertTrue(argument.get('default'), where)

    def testRoslaunchListsTheArguments(self):
        for path in launchFiles():
            names = [a.get('name') for a in ElementTree.parse(path).getroot().findall('arg')]
            listed = roslaunch('--ros-args', str(path))
            self.assertEqual(listed.returncode, 0, listed.stderr)
            self.assertNotIn('Required Arguments', listed.stdout, path.name)
            for name in names:
                self.assertIn(f'{name} (default', listed.stdout, path.name)

    def testEachFileStartsItsNodes(self):
        for name, nodes in NODES.items():
            listed = roslaunch('--nodes', PACKAGE, name)
            self.assertEqual(listed.returncode, 0, f'{name}: {listed.stderr}')
            self.assertEqual(set(listed.stdout.split()), nodes, name)

    def testNothingIsStartedAgainBehindTheUsersBack(self):
        for path in launchFiles():
            for node in ElementTree.parse(path).getroot().iter('node'):
                self.assertIsNone(node.get('respawn'), path.name)

    def testFramesOverruleTheConfigurationOnlyWhereGiven(self):
        path = str(ROOT / 'launch' / 'slam.launch')
        given = yaml.safe_load(roslaunch('--dump-params', path, 'base_frame:=base_link').stdout)
        shipped = yaml.safe_load(roslaunch('--dump-params', path).stdout)
        configured = yaml.safe_load((ROOT / 'config' / 'slam.yaml').read_text())
        self.assertEqual(given['/scan_matcher/base_frame'], 'base_link')
        self.assertEqual(given['/motion_model/base_frame'], 'base_link')
        self.assertEqual(shipped['/scan_matcher/base_frame'],
                         configured['scan_matcher']['base_frame'])
        self.assertEqual(given['/graph_slam/map_frame'], configured['graph_slam']['map_frame'])

    def testPackagesThatDebianLacksAreLookedForOnlyOnRequest(self):
        asked = roslaunch('--nodes', PACKAGE, 'turtlebot.launch', 'bringup:=true')
        self.assertNotEqual(asked.returncode, 0)
        self.assertIn('turtlebot_bringup', asked.stderr)


class DescriptionTest(unittest.TestCase):

    def setUp(self):
        self.robot = ElementTree.parse(ROOT / 'urdf' / 'turtlebot2.urdf').getroot()
        self.joints = {joint.find('child').get('link'): joint
                       for joint in self.robot.findall('joint')}

    def originOf(self, link):
        """Position of a link in base_footprint [m]; above the wheels, nothing is turned."""
        position = [0.0, 0.0, 0.0]
        while link in self.joints:
            joint = self.joints[link]
            step = vector(joint.find('origin').get('xyz'))
            position = [a + b for a, b in zip(position, step)]
            link = joint.find('parent').get('link')
        return position

    def testLinksAreThoseOfATurtleBot(self):
        self.assertEqual({link.get('name') for link in self.robot.findall('link')}, LINKS)

    def testLinksFormOneTreeOnTheFootprint(self):
        self.assertEqual(LINKS - set(self.joints), {'base_footprint'})

    def testWheelsStandOnTheFloor(self):
        for side in ('left', 'right'):
            joint = self.joints[f'wheel_{side}_link']
            self.assertEqual(joint.get('name'), f'wheel_{side}_joint')
            self.assertEqual(joint.get('type'), 'continuous')
            link = self.robot.find(f"link[@name='wheel_{side}_link']")
            radius = float(link.find('visual/geometry/cylinder').get('radius'))
            self.assertAlmostEqual(radius, 0.035)
            self.assertAlmostEqual(self.originOf(f'wheel_{side}_link')[2], radius)
        track = self.originOf('wheel_left_link')[1] - self.originOf('wheel_right_link')[1]
        self.assertAlmostEqual(track, 0.230)

    def testTheSimulatorsLaserIsWhereTheDescriptionHasIt(self):
        config = yaml.safe_load((ROOT / 'config' / 'simulator.yaml').read_text())
        self.assertEqual(self.originOf('laser'), [0.10, 0.0, 0.20])
        self.assertEqual(config['laser_pose'], [0.10, 0.0, 0.0])

    def testNoPoleStandsInTheLasersView(self):
        laser = self.originOf('laser')
        for link in self.robot.findall('link'):
            for visual in link.findall('visual'):
                cylinder = visual.find('geometry/cylinder')
                if cylinder is None or visual.find('material').get('name') != 'pole_silver':
                    continue
                offset = vector(visual.find('origin').get('xyz'))
                x, y, z = (a + b - c for a, b, c in zip(self.originOf(link.get('name')), offset,
                                                        laser))
                if abs(z) > float(cylinder.get('length')) / 2.0:
                    continue
                seen_under = math.asin(float(cylinder.get('radius')) / math.hypot(x, y))
                self.assertGreater(abs(math.atan2(y, x)) - seen_under, HOKUYO_HALF_VIEW)

    def testRobotStatePublisherReadsItAndPublishesTheLaser(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        try:
            found = buffer.lookup_transform('base_footprint', 'laser', rospy.Time(0),
                                            rospy.Duration(20.0)).transform
            camera = buffer.lookup_transform('base_footprint', 'camera_rgb_optical_frame',
                                             rospy.Time(0), rospy.Duration(5.0)).transform
        finally:
            listener.unregister()
        laser = [found.translation.x, found.translation.y, found.translation.z]
        for measured, wanted in zip(laser, (0.10, 0.0, 0.20)):
            self.assertAlmostEqual(measured, wanted, places=9)
        self.assertAlmostEqual(found.rotation.w, 1.0)
        # Optical frames look along z: seen from the base, that is straight ahead.
        q = camera.rotation
        self.assertAlmostEqual(2.0 * (q.x * q.z + q.w * q.y), 1.0, places=6)


if __name__ == '__main__':
    rospy.init_node('launch_test')
    rostest.rosrun(PACKAGE, 'launch_test', '__main__')
