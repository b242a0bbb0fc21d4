#!/usr/bin/python3
"""How the node simulator starts, or says why not."""
import pathlib
import signal
import subprocess
import tempfile
import unittest

import rospy
from rosgraph_msgs.msg import Clock

from simulator_support import DEADLINE, Recorder, executable, refusal


class StartTest(unittest.TestCase):
    """Simulators beside the one of the .test file; most of them end at once."""

    def setUp(self):
        self.world = rospy.get_param('~world')
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def refuse(self, name, *arguments):
        return refusal(self, 'simulator', f'simulator_{name}', arguments)

    def world_file(self, text):
        path = pathlib.Path(self.folder.name) / 'bad.world.yaml'
        path.write_text(text, encoding='utf-8')
        return str(path)

    def test_names_an_unknown_key_and_the_nearest_known_one(self):
        said = self.refuse('unknown', f'_world:={self.world}', '_speeed:=2.0')
        self.assertRegex(said, r'simulator_unknown/speeed\b.*\bspeed\b')

    def test_names_an_unknown_key_in_a_group(self):
        said = self.refuse('group', f'_world:={self.world}', '_hokuyo/beems:=100')
        self.assertRegex(said, r'hokuyo/beems\b.*\bbeams\b')

    def test_names_a_key_of_the_wrong_type(self):
        self.assertIn('simulator_type/speed',
                      self.refuse('type', f'_world:={self.world}', '_speed:=fast'))

    def test_names_a_key_out_of_range(self):
        self.assertIn('hokuyo/rate',
                      self.refuse('range', f'_world:={self.world}', '_hokuyo/rate:=-1.0'))

    def test_names_every_fault_at_once(self):
        said = self.refuse('many', f'_world:={self.world}', '_speed:=-1', '_seed:=1.5',
                           '_laser_pose:=[0.1]')
        for key in ('speed', 'seed', 'laser_pose'):
            self.assertIn(key, said)

    def test_names_keys_that_do_not_fit_together(self):
        self.assertIn('time_step', self.refuse('fit', f'_world:={self.world}', '_time_step:=0.5'))

    def test_asks_for_a_world(self):
        self.assertIn('world', self.refuse('worldless'))

    def test_names_the_world_that_is_not_there(self):
        self.assertIn('/nowhere.world.yaml', self.refuse('nowhere', '_world:=/nowhere.world.yaml'))

    def test_names_the_key_of_a_world_that_is_wrong(self):
        path = self.world_file('map: x.yaml\ndescription: x\nstart: [0, 0]\n')
        said = self.refuse('start', f'_world:={path}')
        self.assertIn(path, said)
        self.assertIn("'start'", said)

    def test_says_that_the_start_is_in_a_wall(self):
        maze = pathlib.Path(self.world).with_name('maze.yaml')
        path = self.world_file(f'map: {maze}\ndescription: x\nstart: [0.05, 0.05, 0]\n')
        self.assertIn('(0.05, 0.05) is in an obstacle', self.refuse('wall', f'_world:={path}'))

    def test_the_clock_stands_until_subscribers_had_their_chance(self):
        clock = Recorder('other_clock', Clock)
        process = subprocess.Popen(
            [executable('simulator'), '__name:=simulator_waiting', '__ns:=waiting',
             f'_world:={self.world}', '_start_time:=7.5', '_start_delay:=3.0', '/clock:=/other_clock',
             '/tf:=/other_tf'])
        try:
            clock.wait(60)
        finally:
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(DEADLINE), 0)
        times = [message.clock.to_sec() for message in clock.messages]
        self.assertEqual(times[0], 7.5)
        self.assertGreater(times.count(7.5), 5)
        self.assertGreater(times[-1], 7.5)
        self.assertEqual(times, sorted(times))


if __name__ == '__main__':
    import rostest
    rospy.init_node('simulator_start_test')
    rostest.rosrun('omega_slam', 'simulator_start', StartTest)
