#include "omega_slam/slam/front_end.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/covariance.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;

namespace {

/// No odometry is better than this between two keyframes, even of a robot that stands: floors and
/// bumps.
constexpr double kOdometryFloorTranslation = 0.01;  // [m]
constexpr double kOdometryFloorRotation = 0.005;    // [rad]

/// Squared Mahalanobis distance from which on odometry counts as wrong.
constexpr double kSlip = 16.0;

Eigen::Matrix3d withoutNegatives(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(matrix);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
         axes.eigenvectors().transpose();
}

}  // namespace

std::vector<std::string> FrontEndConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("keyframe_translation", keyframe_translation, 0.0);
  violations.requireAbove("keyframe_rotation", keyframe_rotation, 0.0);
  violations.requireAtLeast("keyframe_time", keyframe_time, 0.0);
  violations.requireWithin("min_confidence", min_confidence, 0.0, 1.0);
  violations.include("surroundings", surroundings.validate());
  std::vector<std::string> sentences = violations.sentences();
  for (const std::string& sentence : matching.validate()) {
    sentences.push_back(sentence);
  }
  return sentences;
}

FrontEnd::FrontEnd(const FrontEndConfig& config)
    : config_((geometry::throwIfAny(config.validate()), config)),
      tracker_(config.matching, config.min_confidence),
      surroundings_(config.surroundings, config.matching.scan_to_map.map) {}

FrontEndResult FrontEnd::process(const sensing::Sweep& sweep,
                                 const motion::Prediction& prediction) {
  if (surroundings_.keyframes().empty()) {
    return begin(sweep, prediction);
  }
  const TrackedScan tracked =
      tracker_.track(surroundings_.map(), viewOf(sweep), belief_, stepTo(prediction));
  FrontEndResult result;
  result.match = tracked.match;
  result.match_trusted = tracked.is_trusted;
  result.T_keyframe_base = relativePose(surroundings_.newest(), tracked.belief.pose);
  result.keyframe_before = surroundings_.keyframes().back()->id;
  belief_ = tracked.belief;
  const Pose2& T_map_local = surroundings_.mapFromLocal();
  result.belief = {T_map_local * belief_.pose,
                   geometry::rotateCovariance(belief_.covariance, T_map_local.theta)};
  const double seconds = sweep.stamp - surroundings_.keyframes().back()->sweep.stamp;
  if (isKeyframeDue(result.T_keyframe_base, seconds)) {
    makeKeyframe(sweep, prediction, tracked, result);
  } else if (tracked.is_trusted) {
    surroundings_.addGlance(viewOf(sweep), belief_.pose);
  }
  last_ = prediction;
  return result;
}

FrontEndResult FrontEnd::begin(const sensing::Sweep& sweep, const motion::Prediction& prediction) {
  FrontEndResult result;
  result.keyframe = std::make_shared<const Keyframe>(Keyframe{0, prediction.T_odom_base, sweep});
  surroundings_.add(result.keyframe, {});
  belief_ = {};
  last_ = prediction;
  last_.covariance.setZero();
  return result;
}

/// The motion since the last sweep. Predictions tell the uncertainty since the last keyframe; what
/// it has grown by is that of the step.
OdometryStep FrontEnd::stepTo(const motion::Prediction& prediction) const {
  OdometryStep step;
  step.motion = relativePose(last_.T_odom_base, prediction.T_odom_base);
  Eigen::Matrix3d moved = Eigen::Matrix3d::Identity();
  moved(0, 2) = -(prediction.T_odom_base.y - last_.T_odom_base.y);
  moved(1, 2) = prediction.T_odom_base.x - last_.T_odom_base.x;
  const Eigen::Matrix3d grown =
      withoutNegatives(prediction.covariance - moved * last_.covariance * moved.transpose());
  step.covariance = geometry::rotateCovariance(grown, -last_.T_odom_base.theta);
  return step;
}

void FrontEnd::makeKeyframe(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                            const TrackedScan& tracked, FrontEndResult& result) {
  const Keyframe& before = *surroundings_.keyframes().back();
  result.keyframe =
      std::make_shared<const Keyframe>(Keyframe{before.id + 1, prediction.T_odom_base, sweep});
  result.constraints.push_back(
      odometryConstraint(before, *result.keyframe, prediction.covariance, tracked));
  if (tracked.is_trusted) {
    matching::MatchResult match = tracked.match;
    match.T_reference_scan = result.T_keyframe_base;
    match.covariance = geometry::rotateCovariance(match.covariance, -surroundings_.newest().theta);
    result.constraints.push_back(
        matchConstraint(before.id, result.keyframe->id, match, ConstraintKind::kMatch));
  }
  surroundings_.add(result.keyframe, belief_.pose);
}

/// What the odometry says of the motion between two keyframes. The prediction's covariance is of
/// just that motion, in the axes of the odometry frame. Where a trusted match contradicts it, it is
/// loosened until it does not.
Constraint FrontEnd::odometryConstraint(const Keyframe& from, const Keyframe& to,
                                        const Eigen::Matrix3d& covariance_in_odom,
                                        const TrackedScan& tracked) const {
  Constraint constraint;
  constraint.from = from.id;
  constraint.to = to.id;
  constraint.T_from_to = relativePose(from.T_odom_base, to.T_odom_base);
  Eigen::Matrix3d covariance =
      tracker_.odometryScale() *
      geometry::rotateCovariance(covariance_in_odom, -to.T_odom_base.theta);
  covariance.diagonal() +=
      Eigen::Vector3d(kOdometryFloorTranslation, kOdometryFloorTranslation, kOdometryFloorRotation)
          .cwiseAbs2();
  if (tracked.is_trusted) {
    const Pose2 seen = relativePose(surroundings_.newest(), tracked.belief.pose);
    const Eigen::Vector3d error = relativePose(constraint.T_from_to, seen).vector();
    if (error.dot(covariance.inverse() * error) > kSlip) {
      covariance += error * error.transpose();
    }
  }
  constraint.information = covariance.inverse();
  constraint.information =
      0.5 * (constraint.information + constraint.information.transpose()).eval();
  constraint.kind = ConstraintKind::kOdometry;
  return constraint;
}

void FrontEnd::believe(const graph::PoseGraph& graph) {
  if (surroundings_.keyframes().empty()) {
    return;
  }
  const Pose2 before = surroundings_.newest();
  const Pose2 after = surroundings_.believe(graph);
  belief_.pose = after * relativePose(before, belief_.pose);
  belief_.covariance = geometry::rotateCovariance(belief_.covariance, after.theta - before.theta);
}

void FrontEnd::reset() { *this = FrontEnd(config_); }

bool FrontEnd::isKeyframeDue(const Pose2& motion, double seconds) const {
  return std::hypot(motion.x, motion.y) >= config_.keyframe_translation ||
         std::abs(motion.theta) >= config_.keyframe_rotation ||
         (config_.keyframe_time > 0.0 && seconds >= config_.keyframe_time);
}

}  // namespace omega_slam::slam
