#!/usr/bin/env python3
"""map_publisher: a saved map on latched topics and by service; files that can't be used end it."""
import pathlib
import sys

import rospy
import rostest
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest  # noqa: E402  (it lies beside this file)

NAME = 'map_publisher'
GOOD = {'image': 'floor.pgm', 'resolution': '0.1', 'origin': '[-2.5, 3, 0]', 'negate': '0',
        'occupied_thresh': '0.65', 'free_thresh': '0.196'}
PIXELS = bytes([0, 205, 254,  # the top row
                254, 254, 0])


class MapPublisherTest(NodeTest):

    def write(self, changes=None, pixels=PIXELS):
        """A map of 3 x 2 cells. @param changes keys of the YAML file, None: left out"""
        folder = self.folder()
        keys = {key: value for key, value in {**GOOD, **(changes or {})}.items() if value is not None}
        (folder / 'floor.pgm').write_bytes(b'P5 3 2 255\n' + pixels)
        (folder / 'floor.yaml').write_text(''.join(f'{key}: {keys[key]}\n' for key in keys))
        return str(folder / 'floor.yaml')

    def testPublishesTheMapForWhoComesLate(self):
        node = self.startNode(NAME, {'map_file': self.write(), 'frame_id': 'world'})
        node.waitUntilItSays('3 x 2 cells of 0.1 m')
        grid = self.listen('map', OccupancyGrid).waitFor()
        self.assertEqual(grid.header.frame_id, 'world')
        self.assertEqual((grid.info.width, grid.info.height), (3, 2))
        self.assertAlmostEqual(grid.info.resolution, 0.1, places=6)
        place = grid.info.origin
        self.assertEqual((place.position.x, place.position.y, place.orientation.w), (-2.5, 3.0, 1.0))
        self.assertEqual(grid.data, (0, 0, 100, 100, -1, 0))
        self.assertEqual(self.listen('map_metadata', MapMetaData).waitFor(), grid.info)
        rospy.wait_for_service('static_map', timeout=20.0)
        self.assertEqual(rospy.ServiceProxy('static_map', GetMap)().map, grid)
        self.assertEqual(node.stop(), 0)

    def testModesReachTheTopic(self):
        self.startNode(NAME, {'map_file': self.write({'mode': 'raw'}, bytes([0, 50, 100,
                                                                             101, 255, 7]))})
        grid = self.listen('map', OccupancyGrid).waitFor()
        self.assertEqual(grid.data, (-1, -1, 7, 0, 50, 100))

    def testTheNavigatorTakesTheMapWhenItComesLater(self):
        self.startNode(NAME, {'map_file': self.write()}).waitUntilItSays('is published')
        self.startNode('navigator', {'radius': 0.2, 'costmap_interval': 0.1})
        costmap = self.listen('costmap', OccupancyGrid).waitFor()
        self.assertEqual((costmap.info.width, costmap.info.height), (3, 2))

    def testFilesThatCanNotBeUsedAreRefused(self):
        absent = str(self.folder() / 'absent.yaml')
        self.checkBadParameters(NAME, [
            ({}, ['map_publisher/map_file', 'path of a map']),
            ({'map_file': absent}, [absent, 'No such file']),
            ({'map_file': self.write({'image': 'other.pgm'})}, ['other.pgm', 'No such file']),
            ({'map_file': self.write({'free_thresh': None})}, ["'free_thresh' is missing"]),
            ({'map_file': self.write({'resolution': '.nan'})}, ["'resolution' must be above 0"]),
            ({'map_file': self.write(pixels=PIXELS[:4])}, ['floor.pgm', 'cut off']),
            ({'map_file': self.write(), 'frame_id': '/map'}, ['map_publisher/frame_id']),
            ({'map_file': self.write(), 'frame': 'map'}, ['map_publisher/frame', 'frame_id']),
        ])


if __name__ == '__main__':
    rospy.init_node('map_publisher_test')
    rostest.rosrun('omega_slam', 'map_publisher_test', MapPublisherTest)
