"""A made-up robot in a made-up room: odometry and scans that agree with one true motion."""
import dataclasses
import math

import rospy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from omega_slam.msg import Constraint, ConstraintArray, Keyframe, Pose2, PoseGraph
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

# Stamps lie some way into the epoch, as a robot's do, but not at the present.
EPOCH = 1000.0  # [s]


@dataclasses.dataclass(frozen=True)
class Pose:
    """A pose in the plane [m, m, rad]; `a * b` composes, as Pose2 of the library."""
    x: float = 0.0
    y: float = 0.0
    theta: float = 0.0

    def __mul__(self, other):
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Pose(self.x + c * other.x - s * other.y, self.y + s * other.x + c * other.y,
                    math.remainder(self.theta + other.theta, 2.0 * math.pi))

    def inverse(self):
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Pose(-c * self.x - s * self.y, s * self.x - c * self.y, -self.theta)

    def distance(self, other):
        return math.hypot(self.x - other.x, self.y - other.y)

    def message(self):
        return Pose2(self.x, self.y, self.theta)

    @staticmethod
    def of(message):
        return Pose(message.x, message.y, message.theta)


def yawOf(quaternion):
    return 2.0 * math.atan2(quaternion.z, quaternion.w)


@dataclasses.dataclass(frozen=True)
class Room:
    """A rectangular room with a pillar, so that no place in it looks like another."""
    left: float = -2.0
    right: float = 5.0
    bottom: float = -1.5
    top: float = 2.5
    pillar: tuple = (2.0, 1.2, 0.4)  # centre x, y, radius [m]

    def range(self, pose, bearing):
        """[m] from the pose to what stands in the direction [rad, seen from the pose]."""
        angle = pose.theta + bearing
        dx, dy = math.cos(angle), math.sin(angle)
        hits = []
        for wall, origin, slope in ((self.left, pose.x, dx), (self.right, pose.x, dx),
                                    (self.bottom, pose.y, dy), (self.top, pose.y, dy)):
            if abs(slope) > 1e-12 and (wall - origin) / slope > 0.0:
                hits.append((wall - origin) / slope)
        x, y, radius = self.pillar
        along = (x - pose.x) * dx + (y - pose.y) * dy
        aside = (x - pose.x)**2 + (y - pose.y)**2 - along**2
        if along > 0.0 and aside < radius**2:
            hits.append(along - math.sqrt(radius**2 - aside))
        return min(hits)


def stamp(seconds):
    """[s] since EPOCH as ROS has it."""
    return rospy.Time.from_sec(EPOCH + seconds)


def scan(seconds, ranges, field_of_view=2.0 * math.pi, frame='laser'):
    message = LaserScan()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = frame
    message.ranges = ranges
    step = field_of_view / max(len(ranges), 1)
    message.angle_min = -0.5 * field_of_view
    message.angle_increment = step
    message.angle_max = message.angle_min + step * max(len(ranges) - 1, 0)
    message.range_min = 0.05
    message.range_max = 10.0
    return message


def roomScan(seconds, pose, room=Room(), beams=360, frame='laser'):
    """What a laser at the pose sees of the room, all round."""
    step = 2.0 * math.pi / beams
    return scan(seconds, [room.range(pose, -math.pi + i * step) for i in range(beams)], frame=frame)


def odometry(seconds, pose, frame='odom'):
    message = Odometry()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = frame
    message.child_frame_id = 'base_footprint'
    message.pose.pose.position.x = pose.x
    message.pose.pose.position.y = pose.y
    message.pose.pose.orientation.z = math.sin(0.5 * pose.theta)
    message.pose.pose.orientation.w = math.cos(0.5 * pose.theta)
    return message


def transform(parent, child, pose=Pose(), roll=0.0, seconds=0.0):
    """A tf message of one transform: turned by the roll about x first, then placed."""
    message = TransformStamped()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = parent
    message.child_frame_id = child
    message.transform.translation.x = pose.x
    message.transform.translation.y = pose.y
    cy, sy = math.cos(0.5 * pose.theta), math.sin(0.5 * pose.theta)
    cr, sr = math.cos(0.5 * roll), math.sin(0.5 * roll)
    rotation = message.transform.rotation
    rotation.w, rotation.x, rotation.y, rotation.z = cy * cr, cy * sr, sy * sr, sy * cr
    return TFMessage([message])


def keyframe(run, number, seconds, odometry_pose=Pose(), returns=((1.0, 0.0), (0.0, 1.0))):
    message = Keyframe()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = 'base_footprint'
    message.run = run
    message.id = number
    message.odometry = odometry_pose.message()
    message.angle_increment = 0.01
    message.x = [x for x, _ in returns]
    message.y = [y for _, y in returns]
    message.kind = bytes([Keyframe.RETURN] * len(returns))
    return message


def roomKeyframe(run, number, seconds, pose, odometry_pose=Pose(), room=Room(), beams=360):
    """A keyframe at the pose with all that it sees of the room."""
    step = 2.0 * math.pi / beams
    bearings = [-math.pi + i * step for i in range(beams)]
    ranges = [room.range(pose, bearing) for bearing in bearings]
    returns = [(r * math.cos(b), r * math.sin(b)) for r, b in zip(ranges, bearings)]
    message = keyframe(run, number, seconds, odometry_pose, returns)
    message.angle_increment = step
    return message


def constraint(source, target, pose, kind=Constraint.MATCH, information=100.0):
    message = Constraint()
    message.from_id = source
    message.to_id = target
    message.pose = pose.message()
    message.information = [information if i % 4 == 0 else 0.0 for i in range(9)]
    message.confidence = 0.9
    message.kind = kind
    return message


def constraints(run, seconds, *members):
    message = ConstraintArray()
    message.header.stamp = stamp(seconds)
    message.run = run
    message.constraints = list(members)
    return message


def poseGraph(run, poses, seconds=0.0):
    """Keyframe i at the i-th pose, a second apart."""
    message = PoseGraph()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = 'map'
    message.run = run
    message.poses = [pose.message() for pose in poses]
    message.stamps = [stamp(seconds + i) for i in range(len(poses))]
    return message


def chain(run, poses, deviation=0.05):
    """The same, each keyframe tied to the one before by where it is, give or take a deviation [m], [rad]."""
    message = poseGraph(run, poses)
    weight = 1.0 / deviation**2
    information = [weight, 0.0, 0.0, 0.0, weight, 0.0, 0.0, 0.0, weight]
    for number, (before, after) in enumerate(zip(poses, poses[1:])):
        message.constraints.append(Constraint(number, number + 1, (before.inverse() * after).message(),
                                              information, 1.0, Constraint.ODOMETRY))
    return message
