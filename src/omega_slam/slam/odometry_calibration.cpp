#include "omega_slam/slam/odometry_calibration.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::slam {

using geometry::Pose2;

namespace {

/// Deviations of the faults of robots as they come, in the order of OdometryFaults.
const Eigen::Vector4d kUsual{0.05, 0.05, 0.05, 0.02};

/// Of the variance at first, that comes back with each motion: what was learnt some hundreds of
/// motions ago counts little.
constexpr double kForgotten = 2e-5;

/// Deviations below which a fault is taken for chance. Far above, it is believed as it is.
constexpr double kChance = 2.0;

/// Squared Mahalanobis distance of which nothing is learnt: slips and wrong matches.
constexpr double kMostSurprise = 12.0;

/// Less may be nothing but noise.
constexpr double kShortArc = 0.05;  // [m]
constexpr double kSmallArc = 0.02;  // [rad]

/// Beyond that, how the robot has come there need not have been an arc.
constexpr double kLongArc = 2.0;   // [m]
constexpr double kLargeArc = 1.0;  // [rad]

/// How the faults show in a motion. Turns come evenly all along an arc, which leads aside by half
/// of what they are wrong by.
OdometryCalibration::Effects effectsOn(const Pose2& motion) {
  const Eigen::RowVector2d turn{motion.theta, motion.x};
  OdometryCalibration::Effects effects;
  effects << motion.x, -motion.y, -0.5 * motion.y * turn,  //
      motion.y, motion.x, 0.5 * motion.x * turn,           //
      0.0, 0.0, turn;
  return effects;
}

/// What of a motion is more than noise.
Pose2 clearPartOf(const Pose2& motion) {
  const bool drives = motion.translation().norm() >= kShortArc;
  const bool turns = std::abs(motion.theta) >= kSmallArc;
  return {drives ? motion.x : 0.0, drives ? motion.y : 0.0, turns ? motion.theta : 0.0};
}

Pose2 moved(const Pose2& motion, const Eigen::Vector4d& faults) {
  return Pose2::fromVector(motion.vector() + effectsOn(motion) * faults);
}

/// Of what is less nobody need hear.
constexpr double kSlight = 0.005;

}  // namespace

std::string describe(const OdometryFaults& faults) {
  constexpr double kDegrees = 180.0 / geometry::kPi;
  std::vector<std::string> parts;
  if (std::abs(faults.way) > kSlight) {
    parts.push_back(fmt::format("ways are {:.1f} % {} than it has them",
                                100.0 * std::abs(faults.way),
                                faults.way > 0.0 ? "longer" : "shorter"));
  }
  if (std::abs(faults.aside) > kSlight) {
    const bool to_left = faults.aside > 0.0;
    parts.push_back(fmt::format(
        "ways lead {:.1f} degrees farther to the {}, as if the laser looked as far to "
        "the {} of its mount",
        kDegrees * std::abs(faults.aside), to_left ? "left" : "right", to_left ? "right" : "left"));
  }
  if (std::abs(faults.turn) > kSlight) {
    parts.push_back(fmt::format("turns are {:.1f} % {}", 100.0 * std::abs(faults.turn),
                                faults.turn > 0.0 ? "larger" : "smaller"));
  }
  if (std::abs(faults.bend) > kSlight) {
    parts.push_back(fmt::format("each metre forward turns by {:.1f} degrees more to the {}",
                                kDegrees * std::abs(faults.bend),
                                faults.bend > 0.0 ? "left" : "right"));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

OdometryCalibration::OdometryCalibration() : covariance_(kUsual.cwiseAbs2().asDiagonal()) {}

/// The faults are looked for in the motion as both have it: in that, the noise of neither shows as
/// a fault. (Turns of a robot that drives straight on are all noise of the odometry; in these, it
/// would seem to overstate every turn.)
void OdometryCalibration::note(const Belief& by_odometry, const Belief& by_match) {
  if (!isFor(by_odometry.pose)) {
    return;
  }
  const Pose2 expected = moved(by_odometry.pose, mean_);
  const Eigen::Vector3d innovation = differenceOf(by_match.pose, expected);
  const Eigen::Matrix3d covariance = by_odometry.covariance + by_match.covariance;
  const Eigen::Vector3d by_both =
      expected.vector() +
      by_odometry.covariance * Eigen::LDLT<Eigen::Matrix3d>(covariance).solve(innovation);
  const Effects effects = effectsOn(clearPartOf(Pose2::fromVector(by_both)));
  const Eigen::LDLT<Eigen::Matrix3d> spread(effects * covariance_ * effects.transpose() +
                                            covariance);
  if (!(innovation.dot(spread.solve(innovation)) <= kMostSurprise)) {
    return;
  }
  const Eigen::Matrix<double, 4, 3> gain = spread.solve(effects * covariance_).transpose();
  mean_ += gain * innovation;
  const Eigen::Matrix4d rest = covariance_ - gain * effects * covariance_;
  covariance_ = 0.5 * (rest + rest.transpose());
  forget(effects);
}

/// What a motion does not show is not forgotten either: a robot that stands for a week, or only
/// turns, knows as much of its ways as before.
void OdometryCalibration::forget(const Effects& effects) {
  const auto isShown = effects.colwise().squaredNorm().array().transpose() > 0.0;
  covariance_.diagonal() +=
      kForgotten * isShown.select(kUsual.cwiseAbs2(), Eigen::Vector4d::Zero());
}

/// Shrunk towards none, as James and Stein do, each by its own deviation.
Eigen::Vector4d OdometryCalibration::believed() const {
  const Eigen::Array4d chance = kChance * kChance * covariance_.diagonal().array();
  return mean_.array() * (1.0 - chance / mean_.array().square().max(chance));
}

OdometryFaults OdometryCalibration::faults() const {
  const Eigen::Vector4d faults = believed();
  return {faults[0], faults[1], faults[2], faults[3]};
}

bool OdometryCalibration::isFor(const Pose2& motion) {
  return motion.translation().norm() <= kLongArc && std::abs(motion.theta) <= kLargeArc;
}

Pose2 OdometryCalibration::corrected(const Pose2& by_odometry) const {
  return isFor(by_odometry) ? moved(by_odometry, believed()) : by_odometry;
}

}  // namespace omega_slam::slam
