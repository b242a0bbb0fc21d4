#include "omega_slam/slam/front_end.h"

#include <Eigen/Core>
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

/// So many keyframes before it are matched with a new one, scan to scan.
constexpr NodeId kPairs = 2;

/// A step of which less is known is one in the dark: nothing was seen on it for long.
constexpr double kDarkTranslation = 0.1;  // [m]
constexpr double kDarkRotation = 0.03;    // [rad]

bool isInTheDark(const OdometryStep& step) {
  const Eigen::Vector3d variances = step.covariance.diagonal();
  return std::sqrt(variances.head<2>().sum()) > kDarkTranslation ||
         std::sqrt(variances.z()) > kDarkRotation;
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
      odometry_(config.max_speed, config.max_turn_rate),
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
  const OdometryStep step = odometry_.stepTo(prediction);
  if (step.has_jumped) {
    result.remarks.emplace_back("the odometry has jumped");
  }
  const matching::View view = viewOf(sweep);
  const TrackedScan tracked = follow(view, step);
  belief_ = tracked.belief;
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
TrackedScan FrontEnd::follow(const matching::View& view, const OdometryStep& step) {
  TrackedScan tracked = tracker_.track(surroundings_.map(), view, belief_, step);
  if (!tracked.is_trusted && !judge_.isLost()) {
    tracked = tracker_.recover(surroundings_.map(), view, tracked);
  }
  if (!isOutOfTheDark(tracked, step)) {
    judge_.note(tracked, step.motion, step.seconds);
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
  return !tracked.is_trusted && !judge_.isLost() && !odometry_.hasJumped() && isInTheDark(step);
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
  odometry_.begin(prediction);
  return result;
}

KeyframePtr FrontEnd::keep(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                           NodeId stretch) const {
  return std::make_shared<const Keyframe>(Keyframe{next(), prediction.T_odom_base, sweep, stretch});
}

void FrontEnd::makeKeyframe(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                            const TrackedScan& tracked, FrontEndResult& result) {
  const Keyframe& before = *surroundings_.keyframes().back();
  result.keyframe = keep(sweep, prediction, before.stretch);
  result.constraints.push_back(odometry_.constraint(before, *result.keyframe, prediction.covariance,
                                                    surroundings_.newest(), tracked));
  if (tracked.is_trusted) {
    matching::MatchResult match = tracked.match;
    match.T_reference_scan = result.T_keyframe_base;
    match.covariance = geometry::rotateCovariance(match.covariance, -surroundings_.newest().theta);
    result.constraints.push_back(
        matchConstraint(before.id, result.keyframe->id, match, ConstraintKind::kMatch));
    matchPairs(tracked, result);
  }
  if (tracked.is_trusted) {
    odometry_.weigh(before, *result.keyframe, prediction.covariance, surroundings_.newest(),
                    tracked.matched);
  }
  surroundings_.add(result.keyframe, belief_.pose);
  odometry_.anchor();
}

/// Keyframes that only the odometry ties to those before, until a loop does. What was drawn would
/// stand beside where it is by as much as the odometry is wrong.
void FrontEnd::beginStretch(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                            const TrackedScan& tracked, FrontEndResult& result) {
  const Keyframe& before = *surroundings_.keyframes().back();
  result.keyframe = keep(sweep, prediction, next());
  result.constraints.push_back(odometry_.constraint(before, *result.keyframe, prediction.covariance,
                                                    surroundings_.newest(), tracked));
  surroundings_.leave();
  surroundings_.add(result.keyframe, belief_.pose);
  belief_.covariance.setZero();
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
  odometry_.anchor();
  judge_.rest();
  relocaliser_.rest();
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
