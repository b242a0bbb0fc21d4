#include "omega_slam/slam/front_end.h"

#include <Eigen/LU>
#include <cmath>

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

/// What the odometry says of the motion between two keyframes. The prediction's covariance is of
/// just that motion, in the axes of the odometry frame.
Constraint odometryConstraint(const Keyframe& from, const Keyframe& to,
                              const Eigen::Matrix3d& covariance_in_odom) {
  Constraint constraint;
  constraint.from = from.id;
  constraint.to = to.id;
  constraint.T_from_to = relativePose(from.T_odom_base, to.T_odom_base);
  Eigen::Matrix3d covariance =
      geometry::rotateCovariance(covariance_in_odom, -to.T_odom_base.theta);
  covariance.diagonal() +=
      Eigen::Vector3d(kOdometryFloorTranslation, kOdometryFloorTranslation, kOdometryFloorRotation)
          .cwiseAbs2();
  constraint.information = covariance.inverse();
  constraint.information =
      0.5 * (constraint.information + constraint.information.transpose()).eval();
  constraint.kind = ConstraintKind::kOdometry;
  return constraint;
}

}  // namespace

std::vector<std::string> FrontEndConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("keyframe_translation", keyframe_translation, 0.0);
  violations.requireAbove("keyframe_rotation", keyframe_rotation, 0.0);
  violations.requireAtLeast("keyframe_time", keyframe_time, 0.0);
  violations.requireAtLeast("local_keyframes", local_keyframes, 1);
  violations.requireWithin("min_confidence", min_confidence, 0.0, 1.0);
  std::vector<std::string> sentences = violations.sentences();
  for (const std::string& sentence : matching.validate()) {
    sentences.push_back(sentence);
  }
  return sentences;
}

FrontEnd::FrontEnd(const FrontEndConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
  matcher_ = matching::makeMatcher(config_.matching);
}

FrontEndResult FrontEnd::process(const sensing::Sweep& sweep,
                                 const motion::Prediction& prediction) {
  FrontEndResult result;
  LocalKeyframe fresh;
  fresh.view = viewOf(sweep);
  if (!local_.empty()) {
    const Keyframe& last = *local_.back().keyframe;
    const Pose2 motion = relativePose(last.T_odom_base, prediction.T_odom_base);
    if (!isKeyframeDue(motion, sweep.stamp - last.sweep.stamp)) {
      return result;
    }
    fresh.T_local_base = local_.back().T_local_base * motion;
  }
  const auto keyframe =
      std::make_shared<const Keyframe>(Keyframe{next_id_, prediction.T_odom_base, sweep});
  fresh.keyframe = keyframe;
  if (!local_.empty()) {
    tieToNewest(fresh, prediction, result);
  }
  local_.push_back(std::move(fresh));
  while (local_.size() > static_cast<std::size_t>(config_.local_keyframes)) {
    local_.pop_front();
  }
  ++next_id_;
  result.keyframe = keyframe;
  return result;
}

void FrontEnd::tieToNewest(LocalKeyframe& fresh, const motion::Prediction& prediction,
                           FrontEndResult& result) const {
  const LocalKeyframe& last = local_.back();
  result.constraints.push_back(
      odometryConstraint(*last.keyframe, *fresh.keyframe, prediction.covariance));
  result.match = matcher_->match(surroundings(), fresh.view,
                                 relativePose(last.T_local_base, fresh.T_local_base));
  result.match_trusted = result.match->confidence >= config_.min_confidence;
  if (!result.match_trusted) {
    return;
  }
  fresh.T_local_base = last.T_local_base * result.match->T_reference_scan;
  result.constraints.push_back(matchConstraint(last.keyframe->id, fresh.keyframe->id, *result.match,
                                               ConstraintKind::kMatch));
}

void FrontEnd::reset() { *this = FrontEnd(config_); }

bool FrontEnd::isKeyframeDue(const Pose2& motion, double seconds) const {
  return std::hypot(motion.x, motion.y) >= config_.keyframe_translation ||
         std::abs(motion.theta) >= config_.keyframe_rotation ||
         (config_.keyframe_time > 0.0 && seconds >= config_.keyframe_time);
}

matching::Reference FrontEnd::surroundings() const {
  matching::Reference reference;
  for (const LocalKeyframe& local : local_) {
    const Pose2 T_newest_local = relativePose(local_.back().T_local_base, local.T_local_base);
    reference.push_back(matching::transformed(T_newest_local, local.view));
  }
  return reference;
}

}  // namespace omega_slam::slam
