#include "nodes/common/run_recorder_end.h"

namespace omega_slam {

RunEnd::Phase RunEnd::update(const RunProgress& progress) {
  if (phase_ == Phase::kRunning) {
    reason_ = findReason(progress);
    if (reason_.empty()) {
      return phase_;
    }
    phase_ = Phase::kSettling;
    end_time_ = progress.time;
    end_wall_time_ = progress.wall_time;
  }
  if (phase_ == Phase::kSettling) {
    settled_ = hasSettled(progress);
    if (settled_ || progress.wall_time - end_wall_time_ >= config_.settle_deadline) {
      phase_ = Phase::kOver;
    }
  }
  return phase_;
}

std::string RunEnd::findReason(const RunProgress& progress) const {
  const std::string stuck = "stuck";
  if (progress.route_status == "done") {
    return "route done";
  }
  if (progress.route_status == "explored") {
    return "exploration ended";
  }
  if (progress.route_status.compare(0, stuck.size(), stuck) == 0) {
    return "robot " + progress.route_status;
  }
  if (config_.duration > 0.0 && progress.elapsed >= config_.duration) {
    return "time is up";
  }
  return {};
}

bool RunEnd::hasSettled(const RunProgress& progress) {
  if (progress.time - end_time_ < config_.settle_time) {
    return false;
  }
  // What is waited for stands still, though the robot may drive on and make more.
  wanted_keyframes_ = wanted_keyframes_.value_or(progress.keyframes);
  if (progress.graph_poses >= *wanted_keyframes_) {
    wanted_stamp_ = wanted_stamp_.value_or(progress.graph_stamp);
  }
  return wanted_stamp_ && progress.map_stamp >= *wanted_stamp_;
}

}  // namespace omega_slam
