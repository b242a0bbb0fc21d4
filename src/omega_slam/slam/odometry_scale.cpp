#include "omega_slam/slam/odometry_scale.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace omega_slam::slam {

namespace {

constexpr double kLeast = 0.1;
constexpr double kMost = 100.0;

constexpr double kKept = 0.98;     // of what was learnt, at each way: fifty of them count
constexpr double kMostStep = 0.7;  // of the logarithm, at one way: a factor of two

/// Squared Mahalanobis distance of which no more is believed: slips and wrong matches.
constexpr double kMostSurprise = 12.0;

using Axes = Eigen::Matrix<double, 2, 3>;

/// The robot's way and its turn, of a robot with this heading.
Axes alongAndTurn(double heading) {
  Axes axes;
  axes << std::cos(heading), std::sin(heading), 0.0,  //
      0.0, 0.0, 1.0;
  return axes;
}

}  // namespace

void OdometryScale::note(const Belief& by_odometry, const Belief& by_match) {
  const Axes axes = alongAndTurn(by_odometry.pose.theta);
  const Eigen::Vector2d error = axes * differenceOf(by_match.pose, by_odometry.pose);
  const Eigen::Matrix2d odometry = scale_ * axes * by_odometry.covariance * axes.transpose();
  const Eigen::Matrix2d match = axes * by_match.covariance * axes.transpose();
  const Eigen::Matrix2d inverse = (odometry + match).inverse();
  const Eigen::Matrix2d share = inverse * odometry;
  const double surprise = error.dot(inverse * error);
  if (!share.allFinite() || !std::isfinite(surprise)) {
    return;
  }
  const double believed = surprise > kMostSurprise ? kMostSurprise / surprise : 1.0;
  const double gradient = 0.5 * (believed * error.dot(share * inverse * error) - share.trace());
  information_ = kKept * information_ + 0.5 * (share * share).trace();
  const double step = std::clamp(gradient / information_, -kMostStep, kMostStep);
  scale_ = std::clamp(scale_ * std::exp(step), kLeast, kMost);
}

}  // namespace omega_slam::slam
