#include "omega_slam/slam/surroundings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::NodeId;

namespace {

/// So many keyframes of its stretch before the newest are drawn, however little is known of them.
constexpr NodeId kTail = 20;

/// What is seen between keyframes is drawn after so much motion.
constexpr double kGlanceSpacing = 0.03;  // [m], [rad]

/// What was seen so many keyframes ago is not drawn anew: keyframes have by then said the same.
constexpr NodeId kGlanceTail = 3;

/// What is drawn may bend by so much before it is drawn anew: half the width of a wall.
constexpr double kBendTranslation = 0.03;  // [m]
constexpr double kBendRotation = 0.01;     // [rad]

}  // namespace

std::vector<std::string> SurroundingsConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("radius", radius, 0.0);
  violations.requireAbove("max_deviation", max_deviation, 0.0);
  violations.requireAtLeast("max_keyframes", max_keyframes, 1);
  return violations.sentences();
}

Surroundings::Surroundings(const SurroundingsConfig& config, const matching::LocalMapConfig& map)
    : config_(config), map_(map) {
  geometry::throwIfAny(config_.validate());
}

void Surroundings::add(const KeyframePtr& keyframe, const Pose2& T_local_base) {
  keyframes_.push_back(keyframe);
  draw(keyframe->id, T_local_base);
}

void Surroundings::draw(NodeId id, const Pose2& T_local_base) {
  (void)map_.insert(viewOf(keyframes_[id]->sweep), T_local_base);
  drawn_[id] = T_local_base;
}

void Surroundings::addGlance(const matching::View& view, const Pose2& T_local_base) {
  const Pose2 T_keyframe_base = relativePose(newest(), T_local_base);
  const NodeId keyframe = keyframes_.back()->id;
  const bool is_first = glances_.empty() || glances_.back().keyframe != keyframe;
  const Pose2 way =
      relativePose(is_first ? Pose2{} : glances_.back().T_keyframe_base, T_keyframe_base);
  if (std::hypot(way.x, way.y) < kGlanceSpacing && std::abs(way.theta) < kGlanceSpacing) {
    return;
  }
  (void)map_.insert(view, T_local_base);
  glances_.push_back({keyframe, T_keyframe_base, view});
  while (glances_.front().keyframe + kGlanceTail < keyframe) {
    glances_.pop_front();
  }
}

Pose2 Surroundings::believe(const graph::PoseGraph& graph) {
  const std::size_t count = std::min(graph.poses.size(), keyframes_.size());
  if (count == 0) {
    return drawn_.empty() ? Pose2{} : newest();
  }
  graph::PathUncertainty known(graph, static_cast<NodeId>(count - 1));
  return believe(graph, known);
}

Pose2 Surroundings::believe(const graph::PoseGraph& graph, graph::PathUncertainty& known) {
  const NodeId last = known.root();
  poses_.assign(graph.poses.begin(), graph.poses.begin() + last + 1);
  if (!isDrawn(last)) {
    return newest();  // the robot has been found elsewhere since
  }
  const auto nearby = wanted(graph, known);
  if (hasBent(last)) {
    redraw(last, nearby);
    T_map_local_ = {};
    return newest();
  }
  T_map_local_ = graph.poses[last] * drawn_.at(last).inverse();
  const Pose2 T_local_graph = T_map_local_.inverse();
  for (const NodeId id : nearby) {
    if (drawn_.count(id) == 0) {
      draw(id, T_local_graph * graph.poses[id]);
    }
  }
  return newest();
}

/// Those to be drawn, in their order.
std::vector<NodeId> Surroundings::wanted(const graph::PoseGraph& graph,
                                         graph::PathUncertainty& known) const {
  const NodeId newest = known.root();
  const auto isSure = [&](NodeId id) {
    return known.placeDeviation(id) <= config_.max_deviation &&
           known.headingDeviation(id) <= config_.max_deviation;
  };
  const NodeId tail = beginOfNewest(kTail, *keyframes_[newest]);
  std::vector<std::pair<double, NodeId>> near;
  for (NodeId id = 0; id < tail; ++id) {
    const double way = distance(graph.poses[id], graph.poses[newest]);
    if (way <= config_.radius && isSure(id)) {
      near.emplace_back(way, id);
    }
  }
  const auto most = std::min(near.size(), static_cast<std::size_t>(config_.max_keyframes));
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(most), near.end());
  std::vector<NodeId> ids;
  for (std::size_t i = 0; i < most; ++i) {
    ids.push_back(near[i].second);
  }
  std::sort(ids.begin(), ids.end());
  for (NodeId id = tail; id <= newest; ++id) {
    ids.push_back(id);
  }
  return ids;
}

bool Surroundings::hasBent(NodeId newest) const {
  const Pose2 T_newest_local = drawn_.at(newest).inverse();
  const Pose2 T_newest_graph = poses_[newest].inverse();
  return std::any_of(drawn_.begin(), drawn_.end(), [&](const auto& drawn) {
    const auto& [id, T_local_base] = drawn;
    if (id >= newest || distance(poses_[id], poses_[newest]) > config_.radius) {
      return false;
    }
    const Pose2 bend = relativePose(T_newest_local * T_local_base, T_newest_graph * poses_[id]);
    return std::hypot(bend.x, bend.y) > kBendTranslation || std::abs(bend.theta) > kBendRotation;
  });
}

void Surroundings::leave() {
  drawn_.clear();
  glances_.clear();
  map_.clear();
}

void Surroundings::moveTo(NodeId center) {
  leave();
  T_map_local_ = {};
  for (const NodeId id : neighboursOf(center, kTail / 2, known())) {
    draw(id, poses_[id]);
  }
}

void Surroundings::redraw(NodeId newest, const std::vector<NodeId>& wanted) {
  const Drawn before = std::exchange(drawn_, {});
  const Pose2 T_graph_local = poses_[newest] * before.at(newest).inverse();
  matching::Reference views;
  const auto place = [&](NodeId id, const Pose2& T_local_base) {
    drawn_[id] = T_local_base;
    views.push_back(transformed(T_local_base, viewOf(keyframes_[id]->sweep)));
  };
  for (const NodeId id : wanted) {
    place(id, poses_[id]);
  }
  for (auto later = before.upper_bound(newest); later != before.end(); ++later) {
    place(later->first, T_graph_local * later->second);
  }
  for (const Glance& glance : glances_) {
    const auto keyframe = drawn_.find(glance.keyframe);
    if (keyframe != drawn_.end()) {
      views.push_back(transformed(keyframe->second * glance.T_keyframe_base, glance.view));
    }
  }
  map_.redraw(views);
}

}  // namespace omega_slam::slam
