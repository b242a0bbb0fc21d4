"""What the tests of the simulated robot share."""
import subprocess
import time

import roslib.packages
import rospy

DEADLINE = 60.0  # [s] of wall time for anything to happen


class Recorder:
    """All messages of a topic from now on."""

    def __init__(self, topic, message_type):
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, message_type, self.messages.append,
                                           queue_size=1000)

    def wait(self, count=1):
        wait_until(lambda: len(self.messages) >= count,
                   f'{count} messages on {self.subscriber.resolved_name}')
        return self.messages[:count]

    def last(self):
        self.wait()
        return self.messages[-1]


def wait_until(condition, what):
    end = time.monotonic() + DEADLINE
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f'waited {DEADLINE} s in vain for {what}')
        time.sleep(0.005)


def executable(node):
    """Path of a node's program; rosrun does not look into folders named build."""
    return roslib.packages.find_node('omega_slam', node)[0]


def refusal(test, node, name, arguments):
    """What a node says that must not start with these arguments."""
    result = subprocess.run(
        [executable(node), f'__name:={name}', *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=DEADLINE, check=False,
        universal_newlines=True)
    test.assertEqual(result.returncode, 1, result.stdout)
    test.assertIn('FATAL', result.stdout)
    return result.stdout
