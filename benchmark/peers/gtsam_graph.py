"""Graphs as GTSAM has them."""
import gtsam
import numpy

ANCHOR = 1e-3  # [m], [rad] standard deviation of the prior that holds the first pose


def toPose(values):
    return gtsam.Pose2(*values)


def toFactor(constraint):
    tail, head, measured, information = constraint
    noise = gtsam.noiseModel.Gaussian.Information(numpy.array(information))
    return gtsam.BetweenFactorPose2(tail, head, toPose(measured), noise)


def anchor(name, values):
    return gtsam.PriorFactorPose2(name, toPose(values),
                                  gtsam.noiseModel.Isotropic.Sigma(3, ANCHOR))


def toFactors(graph):
    factors = gtsam.NonlinearFactorGraph()
    first = min(graph.poses)
    factors.add(anchor(first, graph.poses[first]))
    for constraint in graph.constraints:
        factors.add(toFactor(constraint))
    return factors


def toValues(poses):
    values = gtsam.Values()
    for name, pose in poses.items():
        values.insert(name, toPose(pose))
    return values


def posesOf(values):
    poses = {}
    for name in values.keys():
        pose = values.atPose2(name)
        poses[name] = (pose.x(), pose.y(), pose.theta())
    return poses
