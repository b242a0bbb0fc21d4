#include "omega_slam/slam/front_end.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/covariance.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;

namespace {

/// No odometry is better than this between two keyframes, even of a robot that stands: floors and
/// bumps.
constexpr double kOdometryFloorTranslation = 0.01;  // [m]
constexpr double kOdometryFloorRotation = 0.005;    // [rad]

/// Squared Mahalanobis distance from which on the odometry between two keyframes counts as wrong.
constexpr double kSlip = 16.0;

/// Of what the odometry's variance grows by with a step. Steps that follow each other share their
/// errors, so that most of the growth is of what matches have seen already on the steps before.
constexpr double kStepShare = 0.3;

/// So many keyframes before it are matched with a new one, scan to scan.
constexpr NodeId kPairs = 2;

/// [s] by which stamps may be wrong: some computers hand on late what came in time.
constexpr double kLatency = 0.3;

/// A step of which less is known is one in the dark: a scan that nothing was seen before for long.
/// [m], [rad]; of what kStepShare leaves.
constexpr double kDarkTranslation = 0.1;
constexpr double kDarkRotation = 0.03;

/// What is known of a motion during which the odometry has jumped, at least.
constexpr double kJumpTranslation = 0.5;  // [m]
constexpr double kJumpRotation = 0.5;     // [rad]

Eigen::Matrix3d nearlyNothing() {
  return Eigen::Vector3d(kJumpTranslation, kJumpTranslation, kJumpRotation)
      .cwiseAbs2()
      .asDiagonal();
}

bool isInTheDark(const OdometryStep& step) {
  const Eigen::Vector3d variances = step.covariance.diagonal();
  return std::sqrt(variances.head<2>().sum()) > kDarkTranslation ||
         std::sqrt(variances.z()) > kDarkRotation;
}

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
  violations.requireAbove("max_speed", max_speed, 0.0);
  violations.requireAbove("max_turn_rate", max_turn_rate, 0.0);
  violations.requireAbove("lost_distance", lost_distance, 0.0);
  violations.include("surroundings", surroundings.validate());
  std::vector<std::string> sentences = violations.sentences();
  for (const std::string& sentence : matching.validate()) {
    sentences.push_back(sentence);
  }
  return sentences;
}

bool FrontEndConfig::isKeyframeDue(const Pose2& motion, double seconds) const {
  return std::hypot(motion.x, motion.y) >= keyframe_translation ||
         std::abs(motion.theta) >= keyframe_rotation ||
         (keyframe_time > 0.0 && seconds >= keyframe_time);
}

FrontEnd::FrontEnd(const FrontEndConfig& config)
    : config_((geometry::throwIfAny(config.validate()), config)),
      tracker_(config.matching, config.min_confidence, config.places),
      surroundings_(config.surroundings, config.matching.scan_to_map.map),
      judge_(config.lost_distance),
      pairs_(config.matching.match),
      relocaliser_(config.places) {}

FrontEndResult FrontEnd::process(const sensing::Sweep& sweep,
                                 const motion::Prediction& prediction) {
  if (surroundings_.keyframes().empty()) {
    return begin(sweep, prediction);
  }
  FrontEndResult result;
  const OdometryStep step = stepTo(prediction, result);
  const matching::View view = viewOf(sweep);
  const TrackedScan tracked = follow(view, step, prediction.stamp - last_.stamp);
  belief_ = tracked.belief;
  last_ = prediction;
  result.match = tracked.match;
  result.match_trusted = tracked.is_trusted;
  result.is_lost = judge_.isLost();
  result.keyframe_before = surroundings_.keyframes().back()->id;
  if (judge_.isLost()) {
    const auto found = relocaliser_.look(view, prediction.T_odom_base, surroundings_.known());
    if (found) {
      resumeAt(*found, sweep, prediction, result);
      return result;
    }
  } else {
    relocaliser_.rest();
  }
  result.T_keyframe_base = relativePose(surroundings_.newest(), belief_.pose);
  result.belief = beliefInMap();
  if (isOutOfTheDark(tracked, step)) {
    beginStretch(sweep, prediction, tracked, result);
  } else if (!tracked.is_contradicted && !judge_.isLost()) {
    const double seconds = sweep.stamp - surroundings_.keyframes().back()->sweep.stamp;
    if (config_.isKeyframeDue(result.T_keyframe_base, seconds)) {
      makeKeyframe(sweep, prediction, tracked, result);
    } else if (tracked.is_trusted) {
      surroundings_.addGlance(view, belief_.pose);
    }
  }
  return result;
}

/// Tracks a scan, and judges what that says. A robot that is lost goes by its odometry.
TrackedScan FrontEnd::follow(const matching::View& view, const OdometryStep& step, double seconds) {
  TrackedScan tracked = tracker_.track(surroundings_.map(), view, belief_, step);
  if (!tracked.is_trusted && !judge_.isLost()) {
    tracked = tracker_.recover(surroundings_.map(), view, tracked);
  }
  if (!isOutOfTheDark(tracked, step)) {
    judge_.note(tracked, step.motion, seconds);
  }
  if (judge_.isLost()) {
    tracked.belief = tracked.predicted;
    tracked.is_trusted = false;
  }
  return tracked;
}

/// Whether the robot has driven on unseen, to where nothing ties it to what it had seen before. Its
/// odometry still says where that is: it is not lost.
bool FrontEnd::isOutOfTheDark(const TrackedScan& tracked, const OdometryStep& step) const {
  return !tracked.is_trusted && !judge_.isLost() && !odometry_jumped_ && isInTheDark(step);
}

Belief FrontEnd::beliefInMap() const {
  const Pose2& T_map_local = surroundings_.mapFromLocal();
  return {T_map_local * belief_.pose,
          geometry::rotateCovariance(belief_.covariance, T_map_local.theta)};
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

/// The motion since the last sweep; none is known where the odometry has jumped. Predictions tell
/// the uncertainty since the last keyframe; what it has grown by is that of the step. Where they
/// tell less than before, there has been a keyframe, and all of it is.
OdometryStep FrontEnd::stepTo(const motion::Prediction& prediction, FrontEndResult& result) {
  OdometryStep step;
  step.motion = relativePose(last_.T_odom_base, prediction.T_odom_base);
  const double seconds = std::max(prediction.stamp - last_.stamp, 0.0) + kLatency;
  if (std::hypot(step.motion.x, step.motion.y) > config_.max_speed * seconds ||
      std::abs(step.motion.theta) > config_.max_turn_rate * seconds) {
    odometry_jumped_ = true;
    result.remarks.emplace_back("the odometry has jumped");
    return {{}, nearlyNothing()};
  }
  Eigen::Matrix3d moved = Eigen::Matrix3d::Identity();
  moved(0, 2) = -(prediction.T_odom_base.y - last_.T_odom_base.y);
  moved(1, 2) = prediction.T_odom_base.x - last_.T_odom_base.x;
  const Eigen::Matrix3d before = moved * last_.covariance * moved.transpose();
  const bool is_counted_anew = prediction.covariance.trace() < before.trace();
  const Eigen::Matrix3d grown =
      is_counted_anew ? prediction.covariance : withoutNegatives(prediction.covariance - before);
  step.covariance = kStepShare * odometry_scale_.value() *
                    geometry::rotateCovariance(grown, -last_.T_odom_base.theta);
  return step;
}

KeyframePtr FrontEnd::keep(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                           NodeId stretch) const {
  return std::make_shared<const Keyframe>(Keyframe{next(), prediction.T_odom_base, sweep, stretch});
}

void FrontEnd::makeKeyframe(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                            const TrackedScan& tracked, FrontEndResult& result) {
  const Keyframe& before = *surroundings_.keyframes().back();
  result.keyframe = keep(sweep, prediction, before.stretch);
  result.constraints.push_back(
      odometryConstraint(before, *result.keyframe, prediction.covariance, tracked));
  if (tracked.is_trusted) {
    matching::MatchResult match = tracked.match;
    match.T_reference_scan = result.T_keyframe_base;
    match.covariance = geometry::rotateCovariance(match.covariance, -surroundings_.newest().theta);
    result.constraints.push_back(
        matchConstraint(before.id, result.keyframe->id, match, ConstraintKind::kMatch));
    matchPairs(tracked, result);
  }
  if (tracked.is_trusted && !odometry_jumped_) {
    weighOdometry(before, *result.keyframe, prediction.covariance, tracked.matched);
  }
  surroundings_.add(result.keyframe, belief_.pose);
  odometry_jumped_ = false;
}

/// Keyframes that only the odometry ties to those before, until a loop does. What was drawn would
/// stand beside where it is by as much as the odometry is wrong.
void FrontEnd::beginStretch(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                            const TrackedScan& tracked, FrontEndResult& result) {
  const Keyframe& before = *surroundings_.keyframes().back();
  result.keyframe = keep(sweep, prediction, next());
  result.constraints.push_back(
      odometryConstraint(before, *result.keyframe, prediction.covariance, tracked));
  surroundings_.leave();
  surroundings_.add(result.keyframe, belief_.pose);
  belief_.covariance.setZero();
}

/// Learns from what was seen how far the odometry between two keyframes was off.
void FrontEnd::weighOdometry(const Keyframe& from, const Keyframe& to,
                             const Eigen::Matrix3d& covariance_in_odom, const Belief& matched) {
  const Pose2& before = surroundings_.newest();
  const double turn = before.theta - from.T_odom_base.theta;
  odometry_scale_.note({before * relativePose(from.T_odom_base, to.T_odom_base),
                        geometry::rotateCovariance(covariance_in_odom, turn)},
                       matched);
}

/// Adds what the scans of the keyframe and of the newest before it say of each other.
void FrontEnd::matchPairs(const TrackedScan& tracked, FrontEndResult& result) const {
  const NodeId end = result.keyframe->id;
  for (NodeId id = end > kPairs ? end - kPairs : 0; id < end; ++id) {
    if (!surroundings_.isDrawn(id)) {
      continue;  // the robot has been found elsewhere since
    }
    const Pose2& T_local_from = surroundings_.poseOf(id);
    const Belief seen{relativePose(T_local_from, belief_.pose),
                      geometry::rotateCovariance(tracked.match.covariance, -T_local_from.theta)};
    if (const auto pair = pairs_.match(*surroundings_.keyframes()[id], *result.keyframe, seen)) {
      result.constraints.push_back(*pair);
    }
  }
}

/// The robot goes on at another place than it was believed to be at.
void FrontEnd::resumeAt(const Relocation& found, const sensing::Sweep& sweep,
                        const motion::Prediction& prediction, FrontEndResult& result) {
  const Pose2 T_map_before = surroundings_.mapFromLocal() * surroundings_.newest();
  const Pose2 T_map_place = surroundings_.known().poses[found.keyframe];
  result.keyframe = keep(sweep, prediction, next());
  result.constraints.push_back(
      matchConstraint(found.keyframe, result.keyframe->id, found.match, ConstraintKind::kMatch));
  result.match = found.match;
  result.match_trusted = true;
  result.is_lost = false;
  surroundings_.moveTo(found.keyframe);
  belief_ = {T_map_place * found.match.T_reference_scan,
             geometry::rotateCovariance(found.match.covariance, T_map_place.theta)};
  surroundings_.add(result.keyframe, belief_.pose);
  result.T_keyframe_base = relativePose(T_map_before, belief_.pose);
  result.belief = beliefInMap();
  odometry_jumped_ = false;
  judge_.rest();
  relocaliser_.rest();
}

/// What the odometry says of the motion between two keyframes. The prediction's covariance is of
/// just that motion, in the axes of the odometry frame. Where a trusted match contradicts it, it is
/// loosened until it does not; where it has jumped, what was tracked stands in for it.
Constraint FrontEnd::odometryConstraint(const Keyframe& from, const Keyframe& to,
                                        const Eigen::Matrix3d& covariance_in_odom,
                                        const TrackedScan& tracked) const {
  Constraint constraint;
  constraint.from = from.id;
  constraint.to = to.id;
  const Pose2 seen = relativePose(surroundings_.newest(), tracked.belief.pose);
  constraint.T_from_to = odometry_jumped_ ? seen : relativePose(from.T_odom_base, to.T_odom_base);
  Eigen::Matrix3d covariance =
      odometry_scale_.value() *
      geometry::rotateCovariance(covariance_in_odom, -to.T_odom_base.theta);
  covariance.diagonal() +=
      Eigen::Vector3d(kOdometryFloorTranslation, kOdometryFloorTranslation, kOdometryFloorRotation)
          .cwiseAbs2();
  if (odometry_jumped_) {
    covariance += nearlyNothing();
  } else if (tracked.is_trusted) {
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
  moveAlong(before, surroundings_.believe(graph));
}

void FrontEnd::believe(const graph::PoseGraph& graph, graph::PathUncertainty& known) {
  const Pose2 before = surroundings_.newest();
  moveAlong(before, surroundings_.believe(graph, known));
}

/// The newest keyframe lies elsewhere in the local frame, and the robot with it.
void FrontEnd::moveAlong(const Pose2& before, const Pose2& after) {
  belief_.pose = after * relativePose(before, belief_.pose);
  belief_.covariance = geometry::rotateCovariance(belief_.covariance, after.theta - before.theta);
}

void FrontEnd::reset() { *this = FrontEnd(config_); }

}  // namespace omega_slam::slam
