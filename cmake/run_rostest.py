#!/usr/bin/env python3
"""Runs one .test file by rostest in the environment of the build, and judges its result file.

rostest starts a master of its own on a free port. Beyond rostest's exit code this looks into its
result files, and a run that tested nothing is a failure. Skips are not told apart: rosunit forgets
them, so a rostest must bring along all it needs.
"""
import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import xml.etree.ElementTree as ElementTree


def environment(output_dir):
    """The caller's environment, but with the system's Python and nothing of a robot next door."""
    result = dict(os.environ)
    result['PATH'] = '/usr/bin:' + result.get('PATH', '/bin')
    result['ROS_HOME'] = str(output_dir / 'ros_home')
    result['ROS_LOG_DIR'] = str(output_dir / 'log')
    result['ROS_IP'] = '127.0.0.1'  # not by its name, which a bare system may not know
    for name in ('ROS_HOSTNAME', 'ROS_MASTER_URI', 'ROS_NAMESPACE', 'PYTHONHOME'):
        result.pop(name, None)
    return result


def readCases(path):
    """The cases of one result file as (name, whether it failed); rostest nests suites at will."""
    # rostest lets control characters of a node's output through, which XML does not allow.
    text = re.sub('[\x00-\x08\x0b\x0c\x0e-\x1f]', '?', path.read_text(errors='replace'))
    return [(case.get('name', '?'), any(child.tag in ('failure', 'error') for child in case))
            for case in ElementTree.fromstring(text).iter('testcase')]


def judge(cases, returncode):
    """@return (exit code, sentence)"""
    names = ', '.join(name for name, failed in cases if failed)
    if names:
        return 1, f'Failed: {names}.'
    if returncode != 0:
        return 1, f'rostest ended with code {returncode}.'
    if not cases:
        return 1, 'rostest ran no test at all.'
    return 0, f'{len(cases)} cases, none failed.'


def run(arguments):
    output_dir = arguments.output_dir.resolve()
    shutil.rmtree(output_dir, ignore_errors=True)
    output_dir.mkdir(parents=True)
    command = [
        str(arguments.environment), '/usr/bin/python3', '/usr/bin/rostest', '--package',
        'omega_slam', '--pkgdir', str(arguments.source_dir), '--results-base-dir',
        str(output_dir / 'results'), str(arguments.test_file)
    ]
    process = subprocess.Popen(command, env=environment(output_dir))
    try:
        returncode = process.wait(timeout=arguments.timeout)
    except subprocess.TimeoutExpired:
        # As by Ctrl-C: rostest then takes its nodes and its master down with it.
        process.send_signal(signal.SIGINT)
        process.wait(timeout=30)
        return 1, f'Not done after {arguments.timeout:.0f} s.'
    cases = [case for path in (output_dir / 'results').rglob('*.xml') for case in readCases(path)]
    return judge(cases, returncode)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--environment', type=pathlib.Path, required=True,
                        help="the devel space's env.sh")
    parser.add_argument('--source-dir', type=pathlib.Path, required=True)
    parser.add_argument('--output-dir', type=pathlib.Path, required=True,
                        help='emptied, then filled with logs and results')
    parser.add_argument('--timeout', type=float, default=240.0, help='[s]')
    parser.add_argument('test_file', type=pathlib.Path)
    code, sentence = run(parser.parse_args())
    print(sentence)
    return code


if __name__ == '__main__':
    sys.exit(main())
