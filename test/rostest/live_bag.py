"""Plays a bag at real speed through the SLAM nodes: what they cost, and whether the offline tool agrees.

Used by scripts/live_bag.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile
import time

import numpy
import rosbag

import replay_support

PATIENCE = 60.0  # [s] until a node is up; long, since the machine may be busy
SETTLED = 5.0  # [s] after which nodes are watched: what they do to begin with does not count
TICK = os.sysconf('SC_CLK_TCK')


def cpuSeconds(process):
    """@return of a process and all its threads so far, or None once it has ended"""
    try:
        text = pathlib.Path(f'/proc/{process}/stat').read_text()
    except OSError:
        return None
    fields = text.rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def processOf(ros, node):
    """@return the number of its process, once it is up"""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        said = subprocess.run(['rosnode', 'info', node], env=ros.environment, capture_output=True,
                              text=True, check=False).stdout
        lines = [line for line in said.splitlines() if line.startswith('Pid')]
        if lines:
            return int(lines[0].split()[1])
        time.sleep(0.5)
    raise SystemExit(f'{node} has not come up in {PATIENCE:.0f} s.')


def watch(ros, recorder, patience):
    """@return {node: CPU seconds in a second}, until the recorder ends"""
    processes = {node: processOf(ros, node) for node in replay_support.NODES}
    time.sleep(SETTLED)
    begin = {node: cpuSeconds(process) for node, process in processes.items()}
    start = now = time.monotonic()
    end = dict(begin)
    while recorder.poll() is None and now - start < patience:
        time.sleep(1.0)
        newest = {node: cpuSeconds(process) for node, process in processes.items()}
        if None in newest.values():
            break
        end, now = newest, time.monotonic()
    return {node: (end[node] - begin[node]) / (now - start) for node in processes}


def main():
    parser = argparse.ArgumentParser(
        prog='scripts/live_bag',
        description='Plays a bag at real speed through the four SLAM nodes, and prints what share of a '
        'processor each takes, and how far the trajectory lies from that of omega_slam_offline.')
    parser.add_argument('bag', type=pathlib.Path)
    parser.add_argument('launch', nargs='*', help='for slam.launch, as base_frame:=base_link')
    parser.add_argument('--keep', type=pathlib.Path, help='folder that keeps the results')
    arguments = parser.parse_args()
    if not arguments.bag.is_file():
        parser.error(f'{arguments.bag}: there is no such file.')
    with rosbag.Bag(str(arguments.bag)) as bag:
        seconds = bag.get_end_time() - bag.get_start_time()
    run = replay_support.Run(world='', duration=seconds - 1.0, speed=1.0, patience=seconds + 60.0,
                             clock=100)  # as rosbag has it
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        print(f'{arguments.bag.name}: {seconds:.0f} s', flush=True)
        with replay_support.replaying(run, arguments.bag, folder / 'live', arguments.launch) as live:
            shares = watch(*live, run.patience)
        for node, share in shares.items():
            print(f'{node:>14} {100.0 * share:6.2f} % of a processor')
        print(f'{"together":>14} {100.0 * sum(shares.values()):6.2f} %')
        recorded = replay_support.readTrajectory(folder / 'live' / 'results')
        computed = replay_support.readTrajectory(
            replay_support.offline(arguments.bag, folder / 'offline'))
        _, distances, turns = replay_support.differencesOfPoses(recorded, computed)
        print(f'{len(distances)} of {len(computed)} scans; from the offline tool: mean '
              f'{numpy.mean(distances):.4f} m, largest {max(distances):.4f} m and '
              f'{numpy.degrees(max(turns)):.2f} degrees')


if __name__ == '__main__':
    main()
