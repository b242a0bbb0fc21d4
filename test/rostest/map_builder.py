#!/usr/bin/env python3
"""map_builder: the map from keyframes and poses, drawn again when they move, and saved truthfully."""
import math
import pathlib
import sys

import rospy
import rostest
import yaml
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap
from omega_slam.msg import Keyframe, PoseGraph
from omega_slam.srv import SaveMap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from node_test_support import NodeTest  # noqa: E402  (it lies beside this file)
from synthetic import Pose, Room, keyframe, poseGraph, roomKeyframe, stamp  # noqa: E402

NAME = 'map_builder'
RUN = 23
ROOM = Room(bottom=-1.52)  # within a cell, not on the border of two
PATH = [Pose(), Pose(0.5, 0.0, 0.2), Pose(1.0, 0.2, 0.4)]
SHIFT = Pose(0.0, 1.0, 0.0)


def cellAt(grid, x, y):
    column = math.floor((x - grid.info.origin.position.x) / grid.info.resolution)
    row = math.floor((y - grid.info.origin.position.y) / grid.info.resolution)
    if not (0 <= column < grid.info.width and 0 <= row < grid.info.height):
        return -1
    return grid.data[row * grid.info.width + column]


class MapBuilderTest(NodeTest):

    def start(self, parameters=None):
        # Drawn at once, so that no test waits for the interval.
        self.node = self.startNode(NAME, dict({'update_interval': 0.0}, **(parameters or {})))
        self.maps = self.listen('map', OccupancyGrid)
        self.keyframes = self.advertise('keyframe', Keyframe)
        self.graphs = self.advertise('pose_graph', PoseGraph)
        self.connect(self.maps, self.keyframes, self.graphs)

    def service(self, name, service_type):
        rospy.wait_for_service(name, timeout=20.0)
        return rospy.ServiceProxy(name, service_type)

    def send(self, poses, run=RUN, count=None):
        """The keyframes at their true poses; the graph believes them at `poses`."""
        for number in range(len(poses) if count is None else count):
            self.keyframes.publish(roomKeyframe(run, number, number, PATH[number], room=ROOM))
        self.graphs.publish(poseGraph(run, poses))

    def waitForWall(self, y):
        """The first map on which the room's lower wall is drawn at this y."""
        return self.maps.waitFor(lambda m: cellAt(m, 0.51, y) == 100, f'a wall at {y}')

    def mapOf(self, keyframes):
        self.waitForDiagnostic('map_builder: health', 'keyframes in the map', keyframes)
        return self.maps.messages()[-1]

    def testTheMapShowsTheRoomAndIsLatched(self):
        self.start({'map_frame': 'world', 'resolution': 0.1})
        self.send(PATH)
        self.mapOf(3)
        grid = self.listen('map', OccupancyGrid).waitFor()
        self.assertEqual(grid.header.frame_id, 'world')
        self.assertEqual(grid.header.stamp, stamp(2))
        self.assertAlmostEqual(grid.info.resolution, 0.1, places=6)
        self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
        self.assertEqual(set(grid.data), {-1, 0, 100})
        self.assertEqual(cellAt(grid, 0.0, 0.0), 0)
        self.assertEqual(cellAt(grid, 0.51, ROOM.bottom), 100)
        self.assertEqual(cellAt(grid, 2.0, 1.2), -1)  # inside of the pillar
        metadata = self.listen('map_metadata', MapMetaData).waitFor()
        self.assertEqual(metadata, grid.info)
        served = self.service('dynamic_map', GetMap)().map
        self.assertEqual((served.info, served.data), (grid.info, grid.data))
        self.assertEqual(self.node.stop(), 0)

    def testTheMapIsDrawnAgainWhenPosesMove(self):
        self.start()
        self.send(PATH)
        self.waitForWall(ROOM.bottom)
        self.mapOf(3)
        self.graphs.publish(poseGraph(RUN, [SHIFT * pose for pose in PATH]))
        grid = self.waitForWall(ROOM.bottom + SHIFT.y)
        self.assertNotEqual(cellAt(grid, 0.51, ROOM.bottom), 100)
        self.waitForDiagnostic('map_builder: health', 'last drawing, keyframes', 3)

    def testWhilePosesStandOnlyNewKeyframesAreDrawn(self):
        self.start()
        self.send(PATH[:2])
        self.mapOf(2)
        self.keyframes.publish(roomKeyframe(RUN, 2, 2, PATH[2], room=ROOM))
        almost = Pose(0.0, 0.002, 0.0)
        self.graphs.publish(poseGraph(RUN, [almost * pose for pose in PATH]))
        self.mapOf(3)
        self.waitForDiagnostic('map_builder: health', 'last drawing, keyframes', 1)

    def testOnlyWhatHasMovedIsDrawnAgain(self):
        self.start()
        poses = [Pose(0.1 * k, 0.0, 0.0) for k in range(5)]
        for number, pose in enumerate(poses):
            self.keyframes.publish(roomKeyframe(RUN, number, number, pose, room=ROOM))
        self.graphs.publish(poseGraph(RUN, poses))
        self.mapOf(5)
        self.graphs.publish(poseGraph(RUN, poses[:4] + [SHIFT * poses[4]]))
        self.waitForDiagnostic('map_builder: health', 'last drawing, keyframes', 1)

    def testUpdatesCarryWhatHasChanged(self):
        """Whoever follows map_updates has the map that a late subscriber is sent."""
        self.start({'always_send_whole_map': False})
        updates = self.listen('map_updates', OccupancyGridUpdate)
        self.connect(updates)
        self.send(PATH[:1])
        first = self.maps.waitFor()
        self.keyframes.publish(roomKeyframe(RUN, 1, 1, PATH[0], room=ROOM))
        self.graphs.publish(poseGraph(RUN, [PATH[0], Pose(0.0, 0.3, 0.0)]))
        update = updates.waitFor()
        self.assertNothingElse(self.maps, 1)
        self.assertEqual(len(update.data), update.width * update.height)
        cells = list(first.data)
        self.assertNotEqual(set(update.data), {-1})
        for row in range(update.height):
            begin = (update.y + row) * first.info.width + update.x
            cells[begin:begin + update.width] = \
                update.data[row * update.width:(row + 1) * update.width]
        self.assertNotEqual(cells, list(first.data))
        self.maps.close()
        late = self.listen('map', OccupancyGrid).waitFor(lambda m: list(m.data) == cells,
                                                         'the map with its updates')
        self.assertEqual(late.info.origin, first.info.origin)

    def testProbabilitiesAreSentToWhoAsks(self):
        self.start()
        self.send(PATH)
        self.mapOf(3)
        grid = self.listen('map_probability', OccupancyGrid).waitFor()
        self.assertEqual(cellAt(grid, 0.0, 0.0), 13)  # three misses, and the prior
        self.assertGreater(cellAt(grid, 0.51, ROOM.bottom), 50)
        self.assertEqual(cellAt(grid, 2.0, 1.2), -1)

    def testTrianglesFillWhatLiesBetweenBeams(self):
        self.start({'renderer': 'triangle', 'map_frame': 'floor'})
        self.send(PATH[:1])
        self.assertEqual(cellAt(self.waitForWall(ROOM.bottom), 0.0, 0.0), 0)

    def testPosesMayComeBeforeTheirKeyframes(self):
        self.start()
        self.graphs.publish(poseGraph(RUN, PATH))
        self.send(PATH[:1])
        self.mapOf(1)
        self.send(PATH)
        self.mapOf(3)

    def testWithoutPosesThereIsNoMap(self):
        self.start()
        self.keyframes.publish(roomKeyframe(RUN, 0, 0, PATH[0]))
        self.graphs.publish(poseGraph(RUN + 1, PATH))
        self.assertNothingElse(self.maps, 0)
        with self.assertRaises(rospy.ServiceException):
            self.service('dynamic_map', GetMap)()

    def testTheMapIsPublishedAtMostSoOften(self):
        self.start({'update_interval': 3600.0})
        self.send(PATH[:1])
        self.maps.waitFor()
        self.send(PATH)
        self.waitForDiagnostic('map_builder: health', 'keyframes', 3)
        self.assertNothingElse(self.maps, 1)
        # Who saves gets all there is, at once.
        answer = self.service('save_map', SaveMap)(str(self.folder() / 'map'))
        self.assertTrue(answer.success, answer.message)
        self.mapOf(3)

    def testAnEmptyMapTakesNoTurn(self):
        self.start({'update_interval': 3600.0})
        self.keyframes.publish(roomKeyframe(RUN, 0, 0, PATH[0]))
        self.waitForDiagnostic('map_builder: health', 'keyframes', 1)
        self.graphs.publish(poseGraph(RUN, PATH[:1]))
        self.mapOf(1)

    def testSavingAnswersTruthfully(self):
        stem = self.folder() / 'deep' / 'floor'
        self.start({'save_stem': str(stem)})
        save = self.service('save_map', SaveMap)
        refused = save('')
        self.assertFalse(refused.success)
        self.assertIn('no map', refused.message)
        self.assertEqual(refused.paths, [])
        self.send(PATH)
        self.mapOf(3)
        saved = save('')
        self.assertTrue(saved.success, saved.message)
        self.assertEqual(set(saved.paths), {f'{stem}.pgm', f'{stem}.yaml'})
        written = yaml.safe_load(pathlib.Path(f'{stem}.yaml').read_text())
        self.assertAlmostEqual(written['resolution'], 0.05)
        self.assertTrue(pathlib.Path(f'{stem}.pgm').read_bytes().startswith(b'P5'))
        failed = save('/proc/no/map')
        self.assertFalse(failed.success)
        self.assertIn('/proc/no', failed.message)
        self.assertEqual(failed.paths, [])

    def testProbabilitiesAreSavedIfAskedFor(self):
        stem = self.folder() / 'shades'
        self.start({'save_mode': 'raw', 'save_image': 'png'})
        probabilities = self.listen('map_probability', OccupancyGrid)
        self.connect(probabilities)
        self.send(PATH)
        self.mapOf(3)
        saved = self.service('save_map', SaveMap)(str(stem))
        self.assertEqual(saved.paths, [f'{stem}.png', f'{stem}.yaml'], saved.message)
        self.startNode('map_publisher', {'map_file': f'{stem}.yaml'}, ['map:=saved_map'])
        grid = self.listen('saved_map', OccupancyGrid).waitFor()
        shown = probabilities.waitFor(lambda m: sum(c >= 0 for c in m.data) ==
                                      sum(c >= 0 for c in grid.data))
        self.assertEqual(sorted(set(grid.data)), sorted(set(shown.data)))
        self.assertGreater(len(set(grid.data)), 3)

    def testTheMapIsSavedAtTheEndIfAskedFor(self):
        stem = self.folder() / 'last'
        self.start({'save_stem': str(stem), 'save_on_exit': True, 'update_interval': 3600.0})
        self.send(PATH)
        self.waitForDiagnostic('map_builder: health', 'keyframes', 3)
        self.assertEqual(self.node.stop(), 0)
        self.assertTrue(pathlib.Path(f'{stem}.pgm').exists())
        self.assertTrue(pathlib.Path(f'{stem}.yaml').exists())

    def testAnotherRunBeginsAnewAndStraysAreRefused(self):
        self.start()
        self.send(PATH)
        self.mapOf(3)
        self.keyframes.publish(roomKeyframe(RUN + 1, 7, 7, PATH[0]))
        self.waitForRejections(NAME, 'keyframe of another run', 1)
        self.mapOf(3)
        self.send([SHIFT * PATH[0]], run=RUN + 1)
        self.waitForWall(ROOM.bottom + SHIFT.y)
        self.mapOf(1)
        self.node.waitUntilItSays('the map begins anew')

    def testAResetGraphTakesTheMapAway(self):
        self.start()
        self.send(PATH)
        self.mapOf(3)
        self.graphs.publish(poseGraph(RUN, []))
        self.waitForDiagnostic('map_builder: health', 'keyframes', 0)
        with self.assertRaises(rospy.ServiceException):
            self.service('dynamic_map', GetMap)()

    def testKeyframesThatNeverCameAreCounted(self):
        self.start()
        self.send(PATH, count=1)
        self.waitForDiagnostic('map_builder: health',
                               'keyframes that the graph has and the map lacks', 2)

    def testFaultyMessagesAreRefusedAndCounted(self):
        self.start()
        self.send(PATH)
        self.mapOf(3)
        torn = keyframe(RUN, 3, 3)
        torn.kind = torn.kind[:-1]
        self.keyframes.publish(torn)
        self.keyframes.publish(keyframe(RUN, 3, 3, returns=((math.nan, 0.0), (1.0, 0.0))))
        strange = keyframe(RUN, 3, 3)
        strange.kind = bytes([1, 9])
        self.keyframes.publish(strange)
        unstamped = poseGraph(RUN, PATH)
        unstamped.stamps = unstamped.stamps[:-1]
        self.graphs.publish(unstamped)
        for cause in ('keyframe lists differ in length', 'keyframe has a beam that is not finite',
                      'keyframe has a beam of unknown kind',
                      'pose graph has not as many stamps as poses'):
            self.waitForRejections(NAME, cause, 1)
        # Of two graphs at once a busy node takes the newer only.
        self.graphs.publish(poseGraph(RUN, [Pose(), Pose(0.5, math.nan, 0.0), Pose()]))
        self.waitForRejections(NAME, 'pose graph has numbers that are not finite', 1)
        # Poses beyond all maps are no reason to fall over.
        self.graphs.publish(poseGraph(RUN, [Pose(), Pose(1e9, 0.0, 0.0), Pose()]))
        self.waitForDiagnostic('map_builder: health', 'keyframes in the map', 2)
        self.assertIsNone(self.node.process.poll())

    def testBadParametersStopTheNode(self):
        self.checkBadParameters(NAME, [
            ({'resolutoin': 0.05}, ['map_builder/resolutoin', 'resolution']),
            ({'resolution': -0.05}, ['map_builder/resolution']),
            ({'save_on_exit': 1}, ['map_builder/save_on_exit']),
            ({'save_stem': ''}, ['save_stem']),
            ({'save_mode': 'scale'}, ['map_builder/save_image', 'PGM']),
            ({'renderer': 'square'}, ['map_builder/renderer', 'triangle']),
            ({'free_threshold': 0.9}, ['map_builder/free_threshold']),
        ])


if __name__ == '__main__':
    rospy.init_node('map_builder_test')
    rostest.rosrun('omega_slam', 'map_builder_test', MapBuilderTest)
