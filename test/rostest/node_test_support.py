"""What the tests of the nodes share: a node as a process, its topics, its diagnostics, its complaints.

Every wait is for a condition and has a deadline; nothing here sleeps and hopes.
"""
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import roslib.packages
import rospy
from diagnostic_msgs.msg import DiagnosticArray

PACKAGE = 'omega_slam'
PATIENCE = 20.0  # [s] after which something that should happen will not


def waitUntil(condition, what, patience=PATIENCE):
    """Returns the first true value of the condition. @param what a text, or what makes it"""
    deadline = time.monotonic() + patience
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > deadline:
            what = what() if callable(what) else what
            raise AssertionError(f'not within {patience:.0f} s: {what}')
        time.sleep(0.01)


class Node:
    """One node of the package as a process of its own, with what it says."""

    def __init__(self, name, parameters=None, arguments=()):
        self.name = name
        if rospy.has_param('/' + name):
            rospy.delete_param('/' + name)
        if parameters:
            rospy.set_param('/' + name, parameters)
        executable = roslib.packages.find_node(PACKAGE, name)[0]
        self._log = tempfile.NamedTemporaryFile('a')
        environment = dict(os.environ, ROSCONSOLE_FORMAT='[${severity}] ${message}',
                           ROSCONSOLE_STDOUT_LINE_BUFFERED='1')
        self.process = subprocess.Popen([executable, *arguments], stdout=self._log,
                                        stderr=subprocess.STDOUT, env=environment)

    def said(self):
        return pathlib.Path(self._log.name).read_text(errors='replace')

    def waitUntilItSays(self, text, patience=PATIENCE):
        waitUntil(lambda: text in self.said(), lambda: f'{self.name} says "{text}"; it said:\n'
                  f'{self.said()}', patience)

    def exitCode(self, patience=PATIENCE):
        """Of a node that ends by itself."""
        return self.process.wait(timeout=patience)

    def stop(self):
        """As by Ctrl-C. Returns the exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise


class Listener:
    """All messages of a topic since the listener was made."""

    def __init__(self, topic, message_type):
        self._lock = threading.Lock()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self._take, queue_size=1000)
        self.topic = topic

    def _take(self, message):
        with self._lock:
            self._messages.append(message)

    def messages(self):
        with self._lock:
            return list(self._messages)

    def clear(self):
        with self._lock:
            self._messages.clear()

    def isConnected(self):
        return self._subscriber.get_num_connections() > 0

    def waitFor(self, condition=lambda message: True, what='a message', patience=PATIENCE):
        """The first message that meets the condition, however early it came."""
        return waitUntil(lambda: next((m for m in self.messages() if condition(m)), None),
                         lambda: f'{what} on {self.topic}; {len(self.messages())} others came',
                         patience)

    def waitForCount(self, count):
        waitUntil(lambda: len(self.messages()) >= count, lambda: f'{count} messages on '
                  f'{self.topic}; {len(self.messages())} came')
        return self.messages()

    def close(self):
        self._subscriber.unregister()


class NodeTest(unittest.TestCase):
    """A test with nodes, listeners and publishers that are gone afterwards."""

    def setUp(self):
        self._diagnostics = self.listen('/diagnostics', DiagnosticArray)

    def startNode(self, name, parameters=None, arguments=()):
        self._diagnostics.clear()
        node = Node(name, parameters, arguments)
        self.addCleanup(node.stop)
        return node

    def listen(self, topic, message_type):
        listener = Listener(topic, message_type)
        self.addCleanup(listener.close)
        return listener

    def advertise(self, topic, message_type, latch=False):
        """A publisher; connect() waits for its subscribers."""
        publisher = rospy.Publisher(topic, message_type, queue_size=1000, latch=latch)
        self.addCleanup(publisher.unregister)
        return publisher

    def connect(self, *ends):
        """Waits until every publisher has a subscriber and every listener a publisher."""
        for end in ends:
            if isinstance(end, Listener):
                waitUntil(end.isConnected, f'somebody publishes {end.topic}')
            else:
                waitUntil(lambda e=end: e.get_num_connections() > 0,
                          f'somebody listens to {end.name}')

    def newestStatus(self, name):
        """The newest diagnostic status of that name; None while there is none."""
        for array in reversed(self._diagnostics.messages()):
            for entry in array.status:
                if entry.name == name:
                    return entry
        return None

    def diagnosticValues(self, status):
        """Key and value of the newest such status, as {} while there is none."""
        newest = self.newestStatus(status)
        return {pair.key: pair.value for pair in newest.values} if newest else {}

    def waitForHealth(self, node, level, message):
        def isSo():
            newest = self.newestStatus(f'{node}: health')
            return newest is not None and (newest.level, newest.message) == (level, message)
        waitUntil(isSo, f'{node} says that it is: {message}')

    def waitForDiagnostic(self, status, key, value):
        waitUntil(lambda: self.diagnosticValues(status).get(key) == str(value),
                  lambda: f'{status}: {key} = {value}; it is {self.diagnosticValues(status)}')

    def waitForRejections(self, node, cause, count):
        self.waitForDiagnostic(f'{node}: faults', f'rejected: {cause}', count)

    def assertNothingElse(self, listener, count):
        """No more than so many messages came, though a full second of diagnostics has passed."""
        before = len(self._diagnostics.messages())
        waitUntil(lambda: len(self._diagnostics.messages()) > before + 1, 'diagnostics')
        self.assertEqual(len(listener.messages()), count, listener.topic)

    def checkBadParameters(self, name, cases):
        """Each case: parameters that are refused, and words that the sentence must hold."""
        self.addCleanup(rospy.delete_param, '/' + name)
        # No subTest: rosunit does not see what fails in one.
        for parameters, words in cases:
            node = Node(name, parameters)
            self.addCleanup(node.stop)
            self.assertNotEqual(node.exitCode(), 0, parameters)
            for word in ['[FATAL]', *words]:
                self.assertIn(word, node.said(), parameters)

    def folder(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return pathlib.Path(folder.name)
