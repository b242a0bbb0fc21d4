#include "omega_slam/slam/loop_closer.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::NodeId;

std::vector<std::string> LoopCloserConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("search_radius", search_radius, 0.0);
  violations.requireAtLeast("min_separation", min_separation, 1);
  violations.requireAtLeast("max_candidates", max_candidates, 0);
  violations.requireAtLeast("neighbours", neighbours, 0);
  violations.requireWithin("min_confidence", min_confidence, 0.0, 1.0);
  violations.requireWithin("window/translation", window.translation, 0.0, 10.0);
  violations.requireWithin("window/rotation", window.rotation, 0.0, 3.15);
  violations.include("match", match.validate());
  return violations.sentences();
}

namespace {

matching::CorrelativeMatcherConfig matcherConfig(const LoopCloserConfig& config) {
  matching::CorrelativeMatcherConfig matcher;
  matcher.window = config.window;
  return matcher;
}

}  // namespace

LoopCloser::LoopCloser(const LoopCloserConfig& config)
    : config_(config), matcher_(matcherConfig(config), config.match) {
  geometry::throwIfAny(config_.validate());
}

void LoopCloser::addKeyframe(KeyframePtr keyframe) { keyframes_.push_back(std::move(keyframe)); }

void LoopCloser::reset() { keyframes_.clear(); }

std::vector<Constraint> LoopCloser::search(NodeId id, const std::vector<Pose2>& poses) const {
  std::vector<Constraint> loops;
  if (id >= keyframes_.size() || id >= poses.size()) {
    return loops;
  }
  const matching::View scan = viewOf(keyframes_[id]->sweep);
  for (const NodeId candidate : candidates(id, poses)) {
    const matching::Reference reference = surroundings(candidate, poses);
    const Pose2 believed = relativePose(poses[candidate], poses[id]);
    const auto match = matcher_.match(reference, scan, believed);
    // A place that leaves a direction open could be any other one along it.
    if (match.confidence >= config_.min_confidence &&
        match.failure != matching::MatchFailure::kDegenerate) {
      loops.push_back(matchConstraint(candidate, id, match, graph::ConstraintKind::kLoop));
    }
  }
  return loops;
}

std::vector<NodeId> LoopCloser::candidates(NodeId id, const std::vector<Pose2>& poses) const {
  std::vector<NodeId> near;
  const auto separation = static_cast<NodeId>(config_.min_separation);
  for (NodeId earlier = 0; earlier + separation <= id; ++earlier) {
    if (distance(poses[earlier], poses[id]) <= config_.search_radius) {
      near.push_back(earlier);
    }
  }
  std::stable_sort(near.begin(), near.end(), [&](NodeId a, NodeId b) {
    return distance(poses[a], poses[id]) < distance(poses[b], poses[id]);
  });
  // Neighbours on one pass say much the same: of each pass, only the nearest.
  std::vector<NodeId> chosen;
  const auto apart = static_cast<NodeId>(2 * config_.neighbours + 1);
  for (const NodeId candidate : near) {
    const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](NodeId other) {
      return std::max(candidate, other) - std::min(candidate, other) < apart;
    });
    if (is_new && chosen.size() < static_cast<std::size_t>(config_.max_candidates)) {
      chosen.push_back(candidate);
    }
  }
  return chosen;
}

matching::Reference LoopCloser::surroundings(NodeId center, const std::vector<Pose2>& poses) const {
  const auto reach = static_cast<NodeId>(config_.neighbours);
  const NodeId first = center > reach ? center - reach : 0;
  const auto last = std::min<NodeId>(center + reach, static_cast<NodeId>(keyframes_.size() - 1));
  matching::Reference reference;
  for (NodeId id = first; id <= last; ++id) {
    const Pose2 T_center_id = relativePose(poses[center], poses[id]);
    reference.push_back(matching::transformed(T_center_id, viewOf(keyframes_[id]->sweep)));
  }
  return reference;
}

}  // namespace omega_slam::slam
