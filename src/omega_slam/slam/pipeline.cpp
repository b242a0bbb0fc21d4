#include "omega_slam/slam/pipeline.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::slam {

using geometry::Pose2;

Pipeline::Pipeline(const PipelineConfig& config)
    : intake_(config.intake),
      predictor_(config.noise),
      front_end_(config.front_end),
      loops_(config.loops),
      back_end_(config.back_end) {}

ScanOutcome Pipeline::process(const sensing::LaserScan& scan, const sensing::LaserMount& mount,
                              const Pose2& T_odom_start, const Pose2& motion_during_sweep) {
  ScanOutcome outcome;
  if (!T_odom_start.isFinite()) {
    outcome.rejection = "odometry is not finite";
    return outcome;
  }
  sensing::ScanIntakeResult taken = intake_.process(scan, mount, motion_during_sweep);
  const double stamp = taken.sweep ? taken.sweep->stamp : scan.stamp;
  const Pose2 T_odom_base = T_odom_start * taken.T_start_sweep;
  outcome.rejection = taken.rejection;
  outcome.repairs = std::move(taken.repairs);
  if (std::isfinite(stamp)) {
    const auto newest = static_cast<graph::NodeId>(std::max<std::size_t>(keyframes_.size(), 1) - 1);
    tracks_.push_back({stamp, newest, carriedOn(T_odom_base), false});
  }
  if (taken.sweep && frozen_laser_.repeats(scan.ranges, T_odom_base)) {
    taken.sweep.reset();
    outcome.rejection = sensing::FrozenLaser::kRejection;
  }
  if (!taken.sweep) {
    return outcome;
  }
  const motion::Prediction prediction = predictor_.predict(stamp, T_odom_base);
  const FrontEndResult result = front_end_.process(*taken.sweep, prediction);
  outcome.match_untrusted = result.match && !result.match_trusted;
  outcome.is_lost = result.is_lost;
  outcome.repairs.insert(outcome.repairs.end(), result.remarks.begin(), result.remarks.end());
  T_odom_tracked_ = T_odom_base;
  T_keyframe_tracked_ = result.keyframe ? Pose2{} : result.T_keyframe_base;
  tracks_.back().T_keyframe_base = result.T_keyframe_base;
  tracks_.back().is_keyframe = result.keyframe != nullptr;
  if (result.keyframe) {
    addKeyframe(result, outcome);
  }
  return outcome;
}

void Pipeline::addKeyframe(const FrontEndResult& result, ScanOutcome& outcome) {
  outcome.keyframe = true;
  const graph::NodeId id = result.keyframe->id;
  predictor_.anchor(result.keyframe->T_odom_base);
  keyframes_.push_back(result.keyframe);
  const std::string refusal =
      back_end_.addKeyframe(id, result.keyframe->T_odom_base, result.constraints);
  loops_.addKeyframe(result.keyframe);
  if (!refusal.empty()) {
    return;
  }
  graph::PathUncertainty known(graph(), id);
  front_end_.believe(graph(), known);  // as the nodes do, which search for loops meanwhile
  const auto loops = loops_.search(graph(), known);
  outcome.loops = loops.size();
  if (!loops.empty()) {
    back_end_.addConstraints(loops);
    front_end_.believe(graph());
  }
}

const graph::SolveReport& Pipeline::finish() { return back_end_.solve(); }

/// A scan that was not tracked, seen from the newest keyframe: by the odometry since the last that
/// was.
Pose2 Pipeline::carriedOn(const Pose2& T_odom_base) const {
  return keyframes_.empty() ? T_odom_base
                            : T_keyframe_tracked_ * relativePose(T_odom_tracked_, T_odom_base);
}

geometry::Trajectory Pipeline::trajectory() const {
  if (!keyframes_.empty()) {
    return scanTrajectory(tracks_, graph().poses);
  }
  geometry::Trajectory by_odometry;  // without a keyframe there is nothing better
  for (const ScanTrack& track : tracks_) {
    by_odometry.push_back({track.stamp, track.T_keyframe_base});
  }
  return by_odometry;
}

grid::OccupancyGrid Pipeline::map(const mapping::OccupancyMapperConfig& config) const {
  mapping::OccupancyMapper mapper(config);
  for (const KeyframePtr& keyframe : keyframes_) {
    // A sweep that can't be drawn leaves its place empty.
    mapper.put({keyframe->id, sweepOf(keyframe), graph().poses[keyframe->id]});
  }
  return mapper.render();
}

}  // namespace omega_slam::slam
