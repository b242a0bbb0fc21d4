#!/usr/bin/env python3
"""What omega_slam_offline takes for a log: processor time, time a scan, most memory."""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile


def run(program, log, config, out):
    """(processor seconds of the process, most memory that it held [MB], its timing.json)"""
    command = [program, log, '--out', out] + (['--config', config] if config else [])
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f'{program} has failed on {log}.')
    timing = json.loads((pathlib.Path(out) / 'timing.json').read_text(encoding='utf-8'))
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, timing


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('log')
    parser.add_argument('--program', required=True, help='omega_slam_offline')
    parser.add_argument('--name', required=True, help='of the log')
    parser.add_argument('--config', help='parameters')
    parser.add_argument('--rounds', type=int, default=3, help='of which the quickest counts')
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as out:
        rounds = [run(arguments.program, arguments.log, arguments.config, out)
                  for _ in range(arguments.rounds)]
    seconds, _, timing = min(rounds, key=lambda figures: figures[0])
    memory = max(figures[1] for figures in rounds)
    scan = timing['timings']['scan']
    print('log,rounds,scans,cpu_seconds,median_ms,p99_ms,max_ms,peak_mb')
    print(f'{arguments.name},{arguments.rounds},{scan["count"]},{seconds:.4g},{1e3 * scan["median"]:.4g},'
          f'{1e3 * scan["percentile_99"]:.4g},{1e3 * scan["max"]:.4g},{memory:.1f}')


if __name__ == '__main__':
    main()
