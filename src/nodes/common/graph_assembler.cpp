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
    if (known_.insert({constraint.from, constraint.to, constraint.kind}).second) {
      constraints_.push_back(constraint);
      is_news = true;
    }
  }
  return is_news ? Verdict::kTaken : Verdict::kKnown;
}

std::optional<GraphStep> GraphAssembler::next() {
  const auto size = static_cast<graph::NodeId>(stamps_.size());
  if (size > 0) {
    if (auto ready = takeConstraints(size - 1); !ready.empty()) {
      return GraphStep{std::nullopt, std::move(ready)};
    }
  }
  const auto keyframe = keyframes_.find(size);
  const bool is_tied = std::any_of(
      constraints_.begin(), constraints_.end(),
      [&](const graph::Constraint& constraint) { return newestNode(constraint) == size; });
  if (keyframe == keyframes_.end() || (size > 0 && !is_tied)) {
    return std::nullopt;
  }
  GraphStep step{keyframe->second, takeConstraints(size)};
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

std::vector<graph::Constraint> GraphAssembler::takeConstraints(graph::NodeId newest) {
  const auto ready = std::stable_partition(
      constraints_.begin(), constraints_.end(),
      [&](const graph::Constraint& constraint) { return newestNode(constraint) > newest; });
  std::vector<graph::Constraint> taken(ready, constraints_.end());
  constraints_.erase(ready, constraints_.end());
  return taken;
}

}  // namespace omega_slam
