#include "nodes/common/graph_assembler.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace omega_slam {
namespace {

// Messages kept of runs that have not begun; a run begins within a few messages, or never.
constexpr std::size_t kMaxEarly = 1000;

graph::NodeId newestNode(const graph::Constraint& constraint) {
  return std::max(constraint.from, constraint.to);
}

}  // namespace

GraphAssembler::Verdict GraphAssembler::add(const KeyframeArrival& keyframe) {
  if (keyframe.run == ended_run_) {
    return Verdict::kOtherRun;
  }
  if (keyframe.run == run_) {
    if (keyframe.id < stamps_.size() || keyframes_.count(keyframe.id) > 0) {
      return Verdict::kKnown;
    }
    keyframes_[keyframe.id] = keyframe;
    return Verdict::kTaken;
  }
  if (keyframe.id != 0) {
    return Verdict::kOtherRun;
  }
  forget();
  run_ = keyframe.run;
  keyframes_[0] = keyframe;
  std::deque<ConstraintArrival> early;
  std::swap(early, early_);
  for (ConstraintArrival& arrival : early) {
    add(std::move(arrival));
  }
  return Verdict::kNewRun;
}

GraphAssembler::Verdict GraphAssembler::add(ConstraintArrival arrival) {
  if (arrival.run == ended_run_) {
    return Verdict::kOtherRun;
  }
  if (arrival.run != run_) {
    early_.push_back(std::move(arrival));
    if (early_.size() > kMaxEarly) {
      early_.pop_front();
      return Verdict::kOtherRun;
    }
    return Verdict::kTaken;
  }
  bool is_news = false;
  for (const graph::Constraint& constraint : arrival.constraints) {
    const geometry::Pose2& pose = constraint.T_from_to;
    const Key key(constraint.from, constraint.to, constraint.kind, pose.x, pose.y, pose.theta);
    if (known_.insert(key).second) {
      constraints_.push_back(constraint);
      is_news = true;
    }
  }
  return is_news ? Verdict::kTaken : Verdict::kKnown;
}

template <class Condition>
std::vector<graph::Constraint> GraphAssembler::take(Condition condition) {
  const auto taken = std::stable_partition(constraints_.begin(), constraints_.end(),
                                           [&](const auto& c) { return !condition(c); });
  std::vector<graph::Constraint> result(taken, constraints_.end());
  constraints_.erase(taken, constraints_.end());
  return result;
}

std::optional<GraphStep> GraphAssembler::next() {
  const auto size = static_cast<graph::NodeId>(stamps_.size());
  const auto is_among_known = [&](const graph::Constraint& c) { return newestNode(c) < size; };
  if (auto ready = take(is_among_known); !ready.empty()) {
    return GraphStep{std::nullopt, std::move(ready)};
  }
  // A loop does not place a node but moves many: it comes after, for the graph to know it as one.
  const auto ties_next = [&](const graph::Constraint& c) {
    return newestNode(c) == size && c.kind != graph::ConstraintKind::kLoop;
  };
  const auto keyframe = keyframes_.find(size);
  const bool is_tied =
      size == 0 || std::any_of(constraints_.begin(), constraints_.end(), ties_next);
  if (keyframe == keyframes_.end() || !is_tied) {
    return std::nullopt;
  }
  GraphStep step{keyframe->second, take(ties_next)};
  keyframes_.erase(keyframe);
  stamps_.push_back(step.keyframe->stamp);
  return step;
}

void GraphAssembler::reset() {
  forget();
  ended_run_ = run_;
  run_ = 0;
  early_.clear();
}

void GraphAssembler::forget() {
  stamps_.clear();
  keyframes_.clear();
  constraints_.clear();
  known_.clear();
}

}  // namespace omega_slam
