#include "omega_slam/slam/pipeline.h"

#include <cmath>

#include "omega_slam/slam/scan_trajectory.h"

namespace omega_slam::slam {

using geometry::Pose2;

Pipeline::Pipeline(const PipelineConfig& config)
    : intake_(config.intake),
      predictor_(config.noise),
      front_end_(config.front_end),
      loops_(config.loops),
      back_end_(config.back_end) {}

ScanOutcome Pipeline::process(const sensing::LaserScan& scan, const sensing::LaserMount& mount,
                              const Pose2& T_odom_base, const Pose2& motion_during_sweep) {
  ScanOutcome outcome;
  if (!T_odom_base.isFinite()) {
    outcome.rejection = "odometry is not finite";
    return outcome;
  }
  sensing::ScanIntakeResult taken = intake_.process(scan, mount, motion_during_sweep);
  outcome.rejection = taken.rejection;
  outcome.repairs = std::move(taken.repairs);
  if (std::isfinite(scan.stamp)) {
    tracks_.push_back({scan.stamp, T_odom_base});
  }
  if (!taken.sweep) {
    return outcome;
  }
  const motion::Prediction prediction = predictor_.predict(scan.stamp, T_odom_base);
  const FrontEndResult result = front_end_.process(*taken.sweep, prediction);
  outcome.match_untrusted = result.match && !result.match_trusted;
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
  keyframe_tracks_.push_back(tracks_.size() - 1);
  back_end_.addKeyframe(id, result.keyframe->T_odom_base, result.constraints);
  loops_.addKeyframe(result.keyframe);
  const auto loops = loops_.search(id, back_end_.graph().poses);
  outcome.loops = loops.size();
  back_end_.addConstraints(loops);
}

const graph::SolveReport& Pipeline::finish() { return back_end_.solve(); }

geometry::Trajectory Pipeline::trajectory() const {
  std::vector<KeyframePlacement> placements;
  for (const KeyframePtr& keyframe : keyframes_) {
    placements.push_back(
        {keyframe->sweep.stamp, keyframe->T_odom_base, graph().poses[keyframe->id]});
  }
  geometry::Trajectory trajectory;
  trajectory.reserve(tracks_.size());
  std::size_t next = 0;  // first keyframe at or after the scan
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    while (next < placements.size() && keyframe_tracks_[next] < i) {
      ++next;
    }
    const Pose2& T_odom_base = tracks_[i].T_odom_base;
    Pose2 T_map_base = T_odom_base;  // without a keyframe there is nothing better
    if (next > 0 && next < placements.size()) {
      // Shares by the count of scans: stamps of old logs run backwards now and then.
      const auto from = static_cast<double>(keyframe_tracks_[next - 1]);
      const auto to = static_cast<double>(keyframe_tracks_[next]);
      const double share = (static_cast<double>(i) - from) / (to - from);
      T_map_base = poseBetween(placements[next - 1], placements[next], T_odom_base, share);
    } else if (!placements.empty()) {
      T_map_base = carryOn(next == 0 ? placements.front() : placements.back(), T_odom_base);
    }
    trajectory.push_back({tracks_[i].stamp, T_map_base});
  }
  return trajectory;
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
