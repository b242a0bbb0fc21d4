#include "omega_slam/motion/odometry_motion_model.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::motion {

using geometry::angleDifference;
using geometry::normalizeAngle;
using geometry::Pose2;

namespace {

/// Below this the direction of the translation says nothing: a turn on the spot [m].
constexpr double kStandingStill = 1e-4;

double normalDensity(double value, double deviation) {
  if (deviation <= 0.0) {
    return value == 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
  }
  const double z = value / deviation;
  return std::exp(-0.5 * z * z) / (deviation * std::sqrt(2.0 * geometry::kPi));
}

double draw(double deviation, std::mt19937_64& random) {
  return deviation > 0.0 ? std::normal_distribution<double>(0.0, deviation)(random) : 0.0;
}

}  // namespace

std::vector<std::string> OdometryMotionModelConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("rotation_per_rotation", rotation_per_rotation, 0.0);
  violations.requireAtLeast("rotation_per_translation", rotation_per_translation, 0.0);
  violations.requireAtLeast("translation_per_translation", translation_per_translation, 0.0);
  violations.requireAtLeast("translation_per_rotation", translation_per_rotation, 0.0);
  return violations.sentences();
}

RotTransRot RotTransRot::fromMotion(const Pose2& T_start_end) {
  RotTransRot motion;
  motion.trans = std::hypot(T_start_end.x, T_start_end.y);
  if (motion.trans < kStandingStill) {
    motion.trans = 0.0;
    motion.rot1 = T_start_end.theta;
    return motion;
  }
  motion.rot1 = normalizeAngle(std::atan2(T_start_end.y, T_start_end.x));
  if (std::abs(motion.rot1) > geometry::kPi / 2.0) {
    motion.rot1 = normalizeAngle(motion.rot1 + geometry::kPi);
    motion.trans = -motion.trans;
  }
  motion.rot2 = angleDifference(T_start_end.theta, motion.rot1);
  return motion;
}

Pose2 RotTransRot::toMotion() const {
  return {trans * std::cos(rot1), trans * std::sin(rot1), normalizeAngle(rot1 + rot2)};
}

OdometryMotionModel::OdometryMotionModel(const OdometryMotionModelConfig& config)
    : config_(config) {
  geometry::throwIfAny(config_.validate());
}

Eigen::Vector3d OdometryMotionModel::deviations(const RotTransRot& motion) const {
  const auto rotation = [&](double angle) {
    return std::hypot(config_.rotation_per_rotation * angle,
                      config_.rotation_per_translation * motion.trans);
  };
  const double translation =
      std::hypot(config_.translation_per_translation * motion.trans,
                 config_.translation_per_rotation * std::hypot(motion.rot1, motion.rot2));
  return {rotation(motion.rot1), translation, rotation(motion.rot2)};
}

Pose2 OdometryMotionModel::sample(const Pose2& measured, std::mt19937_64& random) const {
  const RotTransRot motion = RotTransRot::fromMotion(measured);
  const Eigen::Vector3d deviation = deviations(motion);
  RotTransRot drawn;
  drawn.rot1 = motion.rot1 - draw(deviation[0], random);
  drawn.trans = motion.trans - draw(deviation[1], random);
  drawn.rot2 = motion.rot2 - draw(deviation[2], random);
  return drawn.toMotion();
}

double OdometryMotionModel::density(const Pose2& hypothesis, const Pose2& measured) const {
  const RotTransRot supposed = RotTransRot::fromMotion(hypothesis);
  const RotTransRot motion = RotTransRot::fromMotion(measured);
  // The textbook takes the deviations from the hypothesis: it is the state, the odometry is the
  // datum.
  const Eigen::Vector3d deviation = deviations(supposed);
  return normalDensity(angleDifference(motion.rot1, supposed.rot1), deviation[0]) *
         normalDensity(motion.trans - supposed.trans, deviation[1]) *
         normalDensity(angleDifference(motion.rot2, supposed.rot2), deviation[2]);
}

Eigen::Matrix3d OdometryMotionModel::covariance(const Pose2& measured) const {
  const RotTransRot motion = RotTransRot::fromMotion(measured);
  const double c = std::cos(motion.rot1);
  const double s = std::sin(motion.rot1);
  Eigen::Matrix3d jacobian;
  jacobian << -motion.trans * s, c, 0.0,  //
      motion.trans * c, s, 0.0,           //
      1.0, 0.0, 1.0;
  const Eigen::Vector3d variance = deviations(motion).cwiseAbs2();
  return jacobian * variance.asDiagonal() * jacobian.transpose();
}

}  // namespace omega_slam::motion
