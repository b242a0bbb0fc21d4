"""Records a short simulated run in a bag, replays it through the SLAM nodes, compares the two.

Used by the test replay.py, which compares once with fixed bounds, and by scripts/replay_bounds, which
repeats the comparison to draw these bounds. Every run has a ROS master of its own.
"""
import argparse
import contextlib
import dataclasses
import json
import os
import pathlib
import signal
import socket
import statistics
import subprocess
import tempfile
import time

import numpy
import rosbag
import roslib.packages
import rospkg
import yaml

TOPICS = ('/scan', '/odom', '/tf', '/tf_static', '/base_pose_ground_truth')
NODES = ('/motion_model', '/scan_matcher', '/graph_slam', '/map_builder')
NEIGHBOUR_CELLS = 2  # an obstacle that far from one of the other map is still the same obstacle
OCCUPIED_GREY = 100  # map.pgm: obstacles are darker


@dataclasses.dataclass
class Run:
    """What is run."""
    world: str = 'lab'
    seed: int = 1
    duration: float = 60.0  # [s] of simulated time
    speed: float = 3.0  # simulated seconds in a real one, for the recording and the replay
    margin: float = 4.0  # [s] of simulated time recorded beyond the duration, for the end to settle
    patience: float = 150.0  # [s] of real time after which a run has failed
    clock: int = 200  # [Hz] of simulated time in a replay


@dataclasses.dataclass
class Difference:
    """How far a replay lies from its recording, after it is laid upon it as well as can be."""
    mean_distance: float  # [m] between poses of the same scan
    max_distance: float  # [m]
    mean_turn: float  # [rad]
    map_mismatch: float  # share of obstacle cells that have no neighbour in the other map
    map_area: float  # relative difference of the area known


def takeInterrupts():
    """For a new process: a shell that runs us in the background has SIGINT ignored."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Ros(contextlib.AbstractContextManager):
    """A master of its own and the processes started on it; all are gone at the end."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        with socket.socket() as listener:
            listener.bind(('', 0))
            self.port = listener.getsockname()[1]
        self.environment = dict(os.environ, ROS_MASTER_URI=f'http://127.0.0.1:{self.port}',
                                ROS_IP='127.0.0.1', ROS_LOG_DIR=str(self.folder / 'log'))
        for name in ('ROS_HOSTNAME', 'ROS_NAMESPACE'):
            self.environment.pop(name, None)
        self.processes = []

    def __exit__(self, *_):
        for process in reversed(self.processes):
            self.stop(process)

    def start(self, *command):
        name = pathlib.Path(command[0]).name
        with open(self.folder / f'{name}_{len(self.processes)}.log', 'w') as log:
            process = subprocess.Popen(command, env=self.environment, stdout=log, stderr=log,
                                       stdin=subprocess.DEVNULL, start_new_session=True,
                                       preexec_fn=takeInterrupts)
        self.processes.append(process)
        return process

    @staticmethod
    def stop(process, patience=25.0):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            try:
                process.wait(patience)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def waitFor(self, sentence, condition, patience=30.0):
        deadline = time.monotonic() + patience
        while not condition():
            if time.monotonic() > deadline:
                raise RuntimeError(f'{sentence}: not within {patience:.0f} s. Logs: {self.folder}')
            time.sleep(0.2)

    def nodes(self):
        listed = subprocess.run(['rosnode', 'list'], env=self.environment, capture_output=True,
                                text=True, check=False)
        return set(listed.stdout.split())

    def startRecorder(self, run, results, world):
        # Not by rosrun: it does not look into folders named build.
        program = roslib.packages.find_node('omega_slam', 'run_recorder')[0]
        return self.start(program, f'_world:={world}', f'_results:={results}',
                          f'_duration:={run.duration}')


def package():
    return pathlib.Path(rospkg.RosPack().get_path('omega_slam'))


def worldFile(run):
    """@return empty where the world is not one of ours"""
    return package() / 'maps' / f'{run.world}.world.yaml' if run.world else ''


def startSlam(ros, launch=()):
    """A master, in simulated time, and the SLAM nodes; not waited for.

    @param launch arguments for slam.launch
    @return the master's process
    """
    core = ros.start('roscore', '-p', str(ros.port))
    ros.waitFor('The master is up', lambda: '/rosout' in ros.nodes())
    subprocess.run(['rosparam', 'set', '/use_sim_time', 'true'], env=ros.environment, check=True)
    ros.start('roslaunch', 'omega_slam', 'slam.launch', *launch)
    return core


def record(run, folder):
    """Runs the demo. @return the bag; the results are in folder/results"""
    folder = pathlib.Path(folder)
    world = worldFile(run)
    bag = folder / 'recorded.bag'
    with Ros(folder) as ros:
        core = startSlam(ros)
        ros.waitFor('The SLAM nodes are up', lambda: set(NODES) <= ros.nodes())
        recorder = ros.startRecorder(run, folder / 'results', world)
        recording = ros.start('rosbag', 'record', '--lz4', '-O', str(bag), *TOPICS)
        ros.waitFor('The recorders are up', lambda: '/run_recorder' in ros.nodes() and any(
            node.startswith('/record_') for node in ros.nodes()))
        ros.start('roslaunch', 'omega_slam', 'simulation.launch', f'world:={world}',
                  f'seed:={run.seed}', f'speed:={run.speed}')
        ros.waitFor('The run ends', lambda: recorder.poll() is not None, run.patience)
        time.sleep(run.margin / run.speed)
        ros.stop(recording)
        assert core.poll() is None
    return bag


def withoutSlam(bag, path):
    """Copies a bag without map -> odom, which the replay makes anew."""
    with rosbag.Bag(str(bag)) as source, rosbag.Bag(str(path), 'w') as target:
        for topic, message, stamp, header in source.read_messages(return_connection_header=True):
            if topic == '/tf':
                message.transforms = [t for t in message.transforms
                                      if t.header.frame_id.lstrip('/') != 'map']
                if not message.transforms:
                    continue
            target.write(topic, message, stamp, connection_header=header)  # it says what is latched
    return path


@contextlib.contextmanager
def replaying(run, bag, folder, launch=()):
    """While inside, a bag plays through the SLAM nodes; its results will be in folder/results.

    @param launch arguments for slam.launch
    @return of entering: the Ros that all runs on, and the process that records the results
    """
    folder = pathlib.Path(folder)
    with Ros(folder) as ros:
        startSlam(ros, launch)
        recorder = ros.startRecorder(run, folder / 'results', worldFile(run))
        ros.waitFor('The nodes are up', lambda: set(NODES) | {'/run_recorder'} <= ros.nodes())
        ros.start('rosbag', 'play', '--clock', '--hz', str(run.clock), '--rate', str(run.speed),
                  '--delay', '3', str(bag))
        yield ros, recorder


def replay(run, bag, folder):
    with replaying(run, bag, folder) as (ros, recorder):
        ros.waitFor('The replay ends', lambda: recorder.poll() is not None, run.patience)


def offline(bag, folder, limit=0.0):
    """The offline tool's results of a bag. @param limit [s] of the bag; 0: all"""
    program = roslib.packages.find_node('omega_slam', 'omega_slam_offline')[0]
    subprocess.run([program, str(bag), '--out', str(folder), '--limit', str(limit)], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return folder


def firstScan(bag):
    """@return its stamp [s]"""
    with rosbag.Bag(str(bag)) as source:
        return next(message.header.stamp.to_sec()
                    for _, message, _ in source.read_messages(topics=['/scan']))


def differenceFromOffline(run, bag, folder):
    """Replays a bag, computes it offline, both to the same scan.

    @return distances [m] and turns [rad] between the poses of all scans that the replay has used
    """
    folder = pathlib.Path(folder)
    replay(run, bag, folder / 'live')
    replayed = readTrajectory(folder / 'live' / 'results')
    limit = max(replayed) - firstScan(bag) + 1e-3
    computed = readTrajectory(offline(bag, folder / 'offline', limit))
    if max(replayed) - min(replayed) < 0.9 * run.duration or not set(replayed) <= set(computed):
        raise RuntimeError(f'{len(replayed)} scans replayed, {len(computed)} computed offline.')
    _, distances, turns = differencesOfPoses(replayed, computed)
    return distances, turns


def readTrajectory(results):
    """@return {stamp [s]: (x [m], y [m], theta [rad])}"""
    rows = numpy.loadtxt(results / 'trajectory.tum', ndmin=2)
    theta = 2.0 * numpy.arctan2(rows[:, 6], rows[:, 7])
    return {row[0]: (row[1], row[2], angle) for row, angle in zip(rows, theta)}


def readMap(results):
    """@return obstacle cells and known cells as booleans (row 0 at the bottom), origin, resolution"""
    info = yaml.safe_load((results / 'map.yaml').read_text())
    with open(results / 'map.pgm', 'rb') as image:
        header = []
        while len(header) < 4:
            header += image.readline().split(b'#')[0].split()
        width, height = int(header[1]), int(header[2])
        pixels = numpy.frombuffer(image.read(), numpy.uint8).reshape(height, width)[::-1]
    return pixels < OCCUPIED_GREY, pixels != 205, numpy.array(info['origin'][:2]), info['resolution']


def matrix(pose):
    x, y, theta = pose
    c, s = numpy.cos(theta), numpy.sin(theta)
    return numpy.array([[c, -s, x], [s, c, y], [0.0, 0.0, 1.0]])


def points(cells, origin, resolution):
    rows, columns = numpy.nonzero(cells)
    return origin + resolution * (numpy.stack([columns, rows], axis=1) + 0.5)


def shareWithoutNeighbour(mine, yours, origin, resolution):
    """Share of `mine` [m] that has none of the obstacle cells `yours` near it."""
    near = numpy.zeros_like(yours)
    padded = numpy.pad(yours, NEIGHBOUR_CELLS)
    for row in range(2 * NEIGHBOUR_CELLS + 1):
        for column in range(2 * NEIGHBOUR_CELLS + 1):
            near |= padded[row:row + yours.shape[0], column:column + yours.shape[1]]
    cells = numpy.floor((mine - origin) / resolution).astype(int)
    inside = ((cells >= 0) & (cells < yours.shape[::-1])).all(axis=1)
    hits = near[cells[inside, 1], cells[inside, 0]].sum()
    return 1.0 - hits / len(mine)


def compareMaps(recorded, replayed, T_recorded_replayed):
    obstacles_a, known_a, origin_a, resolution = readMap(recorded)
    obstacles_b, known_b, origin_b, resolution_b = readMap(replayed)
    assert resolution == resolution_b
    points_a = points(obstacles_a, origin_a, resolution)
    points_b = points(obstacles_b, origin_b, resolution)
    inverse = numpy.linalg.inv(T_recorded_replayed)
    b_in_a = points_b @ T_recorded_replayed[:2, :2].T + T_recorded_replayed[:2, 2]
    a_in_b = points_a @ inverse[:2, :2].T + inverse[:2, 2]
    mismatch = max(shareWithoutNeighbour(b_in_a, obstacles_a, origin_a, resolution),
                   shareWithoutNeighbour(a_in_b, obstacles_b, origin_b, resolution))
    return mismatch, abs(known_b.sum() / known_a.sum() - 1.0)


def bestAlignment(points_a, points_b):
    """@return T_a_b as a matrix, by least squares (Umeyama 1991, without the scale)

    Not by the first pose: what little it turns differently would swing the far end of the building.
    """
    mean_a, mean_b = points_a.mean(axis=0), points_b.mean(axis=0)
    a, b = points_a - mean_a, points_b - mean_b
    theta = numpy.arctan2((b[:, 0] * a[:, 1] - b[:, 1] * a[:, 0]).sum(), (a * b).sum())
    T_a_b = matrix((0.0, 0.0, theta))
    T_a_b[:2, 2] = mean_a - T_a_b[:2, :2] @ mean_b
    return T_a_b


def differencesOfPoses(poses_a, poses_b):
    """@return T_a_b as a matrix, and the distances [m] and turns [rad] between poses of one stamp"""
    stamps = sorted(set(poses_a) & set(poses_b))
    T_a_b = bestAlignment(numpy.array([poses_a[stamp][:2] for stamp in stamps]),
                          numpy.array([poses_b[stamp][:2] for stamp in stamps]))
    distances, turns = [], []
    for stamp in stamps:
        a, b = matrix(poses_a[stamp]), T_a_b @ matrix(poses_b[stamp])
        distances.append(numpy.hypot(*(a[:2, 2] - b[:2, 2])))
        between = a.T @ b
        turns.append(abs(numpy.arctan2(between[1, 0], between[0, 0])))
    return T_a_b, distances, turns


def compare(recorded, replayed, duration):
    """
    @param recorded, replayed folders that run_recorder has written
    @param duration [s] that both were to last
    """
    poses_a, poses_b = readTrajectory(recorded), readTrajectory(replayed)
    end = min(max(poses_a), max(poses_b))  # each goes on until its map has caught up
    wanted = sum(stamp <= end for stamp in poses_a)
    stamps = sorted(set(poses_a) & set(poses_b))
    if end - min(poses_a) < 0.9 * duration or len(stamps) < 0.9 * wanted:
        raise RuntimeError(f'Only {len(stamps)} of {wanted} scans until {end:.1f} s are in both '
                           f'runs, which were to last {duration:.0f} s.')
    T_recorded_replayed, distances, turns = differencesOfPoses(poses_a, poses_b)
    mismatch, area = compareMaps(recorded, replayed, T_recorded_replayed)
    return Difference(float(numpy.mean(distances)), float(numpy.max(distances)),
                      float(numpy.mean(turns)), float(mismatch), float(area))


def rejections(results):
    """What scan_matcher refused in a run: {cause: count}."""
    return json.loads((results / 'report.json').read_text())['scans']['rejections']


def recordAndReplay(run, folder):
    folder = pathlib.Path(folder)
    bag = withoutSlam(record(run, folder / 'recording'), folder / 'replayed.bag')
    replay(run, bag, folder / 'replay')
    return compare(folder / 'recording' / 'results', folder / 'replay' / 'results', run.duration)


def printDistribution(differences):
    print(f'{"figure":>14} {"mean":>9} {"sigma":>9} {"max":>9} {"mean+4sigma":>12}')
    for field in dataclasses.fields(Difference):
        values = [getattr(difference, field.name) for difference in differences]
        mean, sigma = statistics.mean(values), statistics.stdev(values)
        print(f'{field.name:>14} {mean:9.5f} {sigma:9.5f} {max(values):9.5f} '
              f'{mean + 4.0 * sigma:12.5f}')


def main():
    parser = argparse.ArgumentParser(
        prog='scripts/replay_bounds',
        description='Records and replays a short run again and again, and prints how far the replays '
        'lie from their recordings: the bounds of test/rostest/replay.py are mean + 4 sigma.')
    parser.add_argument('--runs', type=int, default=10, help='default: 10')
    parser.add_argument('--keep', type=pathlib.Path, help='folder that keeps bags and results')
    arguments = parser.parse_args()
    if arguments.runs < 2:
        parser.error('--runs needs 2 or more: there is no deviation of fewer.')
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        differences = []
        for number in range(1, arguments.runs + 1):
            differences.append(recordAndReplay(Run(), folder / str(number)))
            print(f'{number:3d}  {differences[-1]}', flush=True)
    printDistribution(differences)


if __name__ == '__main__':
    main()
