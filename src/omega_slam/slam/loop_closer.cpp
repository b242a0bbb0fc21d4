#include "omega_slam/slam/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::NodeId;
using matching::SearchWindow;

namespace {

// To each side that a window spans. Covariances of matches are bounds, so that two of these are
// four of what is seen.
constexpr double kDeviations = 2.0;
// What a window spans at least: the graph's belief of neighbours is not perfect either.
constexpr SearchWindow kLeastWindow{0.2, 0.1};

// Wide windows cost time and can mislead: not every keyframe is searched for in them, and what is
// found is to be confirmed.
constexpr NodeId kWideSpacing = 3;  // keyframes
constexpr NodeId kMemory = 30;      // keyframes that a loop waits for a second one

// Two loops agree if they differ by no more in where they put the robot.
constexpr double kAgreeTranslation = 0.3;  // [m]
constexpr double kAgreeRotation = 0.05;    // [rad]

/// [m] What is seen farther away counts as if it were here: walls at the end of a corridor are few.
constexpr double kFar = 5.0;

/// The middle of what was seen, in the base's frame.
Eigen::Vector2d centreOfView(const sensing::Sweep& sweep) {
  const Eigen::Vector2d laser = sweep.T_base_laser.translation();
  const auto returns = sweep.returns();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& end : returns) {
    const Eigen::Vector2d ray = end - laser;
    sum += ray * std::min(1.0, kFar / ray.norm());
  }
  return laser + sum / std::max(1.0, static_cast<double>(returns.size()));
}

/// Whether two loops, followed one after the other with the graph's paths between, lead back.
bool agree(const Constraint& a, const Constraint& b, const std::vector<Pose2>& poses) {
  const Pose2 by_a = a.T_from_to * relativePose(poses[a.to], poses[b.to]);
  const Pose2 by_b = relativePose(poses[a.from], poses[b.from]) * b.T_from_to;
  const Pose2 gap = relativePose(by_a, by_b);
  return std::hypot(gap.x, gap.y) <= kAgreeTranslation && std::abs(gap.theta) <= kAgreeRotation;
}

/// [m] to a place that is told as seen from a pose. Beyond the farthest that matters, as most are,
/// only that it is: which takes no sine.
double wayTo(const Eigen::Vector2d& seen, const Pose2& pose, const Eigen::Vector2d& p_pose,
             double farthest) {
  const double least = (pose.translation() - seen).norm() - p_pose.norm();
  return least > farthest ? least : (pose * p_pose - seen).norm();
}

}  // namespace

std::vector<std::string> LoopCloserConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("search_radius", search_radius, 0.0);
  violations.requireAtLeast("min_separation", min_separation, 1);
  violations.requireAtLeast("max_candidates", max_candidates, 0);
  violations.requireAtLeast("neighbours", neighbours, 0);
  violations.requireAtLeast("min_deviation", min_deviation, 0.0);
  violations.requireWithin("max_window/translation", max_window.translation, 0.0, 10.0);
  violations.requireWithin("max_window/rotation", max_window.rotation, 0.0, 3.15);
  std::vector<std::string> sentences = violations.sentences();
  for (const std::string& sentence : place.validate()) {
    sentences.push_back(sentence);
  }
  return sentences;
}

LoopCloser::LoopCloser(const LoopCloserConfig& config)
    : config_((geometry::throwIfAny(config.validate()), config)),
      matcher_(config.place),
      relocaliser_(config.place) {}

void LoopCloser::addKeyframe(KeyframePtr keyframe) {
  seen_.push_back(centreOfView(keyframe->sweep));
  keyframes_.push_back(std::move(keyframe));
}

void LoopCloser::reset() { *this = LoopCloser(config_); }

std::vector<Constraint> LoopCloser::search(NodeId id, const graph::PoseGraph& graph) {
  if (id >= keyframes_.size() || id >= graph.poses.size()) {
    return {};
  }
  graph::PathUncertainty known(graph, id);
  return search(graph, known);
}

std::vector<Constraint> LoopCloser::search(const graph::PoseGraph& graph,
                                           graph::PathUncertainty& known) {
  const NodeId id = known.root();
  std::vector<Constraint> loops;
  if (isAdrift(known)) {
    loops = lookEverywhere(graph, id);
  } else {
    relocaliser_.rest();
  }
  for (const Candidate& candidate : candidates(graph, known)) {
    if (!loops.empty() && isWide(candidate.window)) {
      continue;  // once the first is in the graph, the window will be narrow
    }
    const auto more = tryCandidate(id, candidate, graph);
    loops.insert(loops.end(), more.begin(), more.end());
  }
  return loops;
}

/// Whether no window is wide enough for what is known of the stretch before.
bool LoopCloser::isAdrift(graph::PathUncertainty& known) const {
  const NodeId stretch = keyframes_[known.root()]->stretch;
  return stretch > 0 && known.reaches(stretch - 1) &&
         kDeviations * known.placeDeviation(stretch - 1) > config_.max_window.translation;
}

std::vector<Constraint> LoopCloser::lookEverywhere(const graph::PoseGraph& graph, NodeId id) {
  const Keyframe& keyframe = *keyframes_[id];
  const std::vector<Pose2> before(graph.poses.begin(), graph.poses.begin() + keyframe.stretch);
  const auto found =
      relocaliser_.look(viewOf(keyframe.sweep), keyframe.T_odom_base, {keyframes_, before});
  if (!found) {
    return {};
  }
  relocaliser_.rest();
  return {matchConstraint(found->keyframe, id, found->match, graph::ConstraintKind::kLoop)};
}

/// Earlier keyframes worth a match with `id`, those first of which most would be learnt.
std::vector<LoopCloser::Candidate> LoopCloser::candidates(const graph::PoseGraph& graph,
                                                          graph::PathUncertainty& known) const {
  const NodeId id = known.root();
  const auto separation = static_cast<NodeId>(config_.min_separation);
  std::vector<Candidate> all;
  const Eigen::Vector2d seen = graph.poses[id] * seen_[id];
  const double farthest = config_.search_radius + config_.max_window.translation;
  const NodeId end = beginOfNewest(separation, *keyframes_[id]);
  for (NodeId earlier = 0; earlier < end; ++earlier) {
    const double way = wayTo(seen, graph.poses[earlier], seen_[earlier], farthest);
    if (way > farthest || !known.reaches(earlier)) {
      continue;  // what is not reached has retired, and newer ones have seen its place
    }
    const double deviation = known.placeDeviation(earlier);
    const double span = std::min(kDeviations * deviation, config_.max_window.translation);
    if (!(way - span <= config_.search_radius && deviation >= config_.min_deviation)) {
      continue;
    }
    const double turn =
        std::min(kDeviations * known.headingDeviation(earlier), config_.max_window.rotation);
    const SearchWindow window{std::max(span, kLeastWindow.translation),
                              std::max(turn, kLeastWindow.rotation)};
    if (!isWide(window) || id % kWideSpacing == 0) {
      all.push_back(
          {earlier, deviation / (1.0 + std::pow(way / config_.search_radius, 2)), window});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  // Neighbours on one pass say much the same: of each pass, only the best.
  std::vector<Candidate> chosen;
  const auto apart = static_cast<NodeId>(2 * config_.neighbours + 1);
  for (const Candidate& candidate : all) {
    const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      return std::max(candidate.id, other.id) - std::min(candidate.id, other.id) < apart;
    });
    if (is_new && chosen.size() < static_cast<std::size_t>(config_.max_candidates)) {
      chosen.push_back(candidate);
    }
  }
  return chosen;
}

std::vector<Constraint> LoopCloser::tryCandidate(NodeId id, const Candidate& candidate,
                                                 const graph::PoseGraph& graph) {
  const auto reach = static_cast<NodeId>(config_.neighbours);
  const auto place = placeAround(candidate.id, reach, {keyframes_, graph.poses});
  const Pose2 believed = relativePose(graph.poses[candidate.id], graph.poses[id]);
  const auto match =
      matcher_.match(place, viewOf(keyframes_[id]->sweep), believed, candidate.window);
  if (!match) {
    return {};
  }
  const Constraint loop = matchConstraint(candidate.id, id, *match, graph::ConstraintKind::kLoop);
  return isWide(candidate.window) ? confirm(loop, graph) : std::vector<Constraint>{loop};
}

/// The loop with those that agree with it; none as long as it stands alone.
std::vector<Constraint> LoopCloser::confirm(const Constraint& loop, const graph::PoseGraph& graph) {
  std::vector<Constraint> agreeing;
  std::vector<Constraint> others;
  for (const Constraint& earlier : unconfirmed_) {
    if (earlier.to + kMemory >= loop.to) {
      const bool is_other = earlier.to != loop.to;  // what one scan says twice is said once
      (is_other && agree(earlier, loop, graph.poses) ? agreeing : others).push_back(earlier);
    }
  }
  unconfirmed_ = std::move(others);
  if (agreeing.empty()) {
    unconfirmed_.push_back(loop);
  } else {
    agreeing.push_back(loop);
  }
  return agreeing;
}

}  // namespace omega_slam::slam
