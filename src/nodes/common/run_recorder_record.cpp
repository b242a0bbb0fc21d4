#include "nodes/common/run_recorder_record.h"

#include <algorithm>
#include <utility>

namespace omega_slam {
namespace {

geometry::Trajectory sample(const motion::OdometryBuffer& buffer,
                            const std::vector<double>& stamps) {
  geometry::Trajectory trajectory;
  trajectory.reserve(stamps.size());
  for (const double stamp : stamps) {
    if (const auto pose = buffer.at(stamp)) {
      trajectory.push_back({stamp, *pose});
    }
  }
  return trajectory;
}

}  // namespace

void RunRecord::addOdometry(double stamp, const geometry::Pose2& T_odom_base) {
  if (odometry_.add(stamp, T_odom_base) == motion::OdometryVerdict::kAccepted) {
    advance(stamp);
  }
}

void RunRecord::addTruth(double stamp, const geometry::Pose2& T_world_base) {
  const auto before = truth_.empty() ? std::nullopt : truth_.at(truth_.newest());
  if (truth_.add(stamp, T_world_base) != motion::OdometryVerdict::kAccepted) {
    return;
  }
  advance(stamp);
  if (before) {
    distance_ += geometry::distance(*before, T_world_base);
  }
}

void RunRecord::addScan(double stamp) { scan_stamps_.push_back(stamp); }

void RunRecord::addTrack(std::uint64_t run, const slam::ScanTrack& track) {
  if (run != run_) {
    tracks_.clear();
    run_ = run;
  }
  tracks_.push_back(track);
}

void RunRecord::addKeyframe(graph::NodeId id, double stamp) {
  advance(stamp);
  keyframes_ = std::size_t{id} + 1;
}

void RunRecord::setGraph(graph::PoseGraph graph, std::vector<double> stamps,
                         slam::BeliefAccount beliefs) {
  graph_ = std::move(graph);
  graph_stamps_ = std::move(stamps);
  beliefs_ = std::move(beliefs);
}

void RunRecord::setMap(grid::OccupancyGrid map, double stamp) {
  map_ = std::move(map);
  map_stamp_ = stamp;
}

geometry::Trajectory RunRecord::estimate() const {
  return slam::scanTrajectory(tracks_, graph_.poses);
}

geometry::Trajectory RunRecord::truth() const { return sample(truth_, scan_stamps_); }

geometry::Trajectory RunRecord::odometry() const { return sample(odometry_, scan_stamps_); }

std::optional<geometry::Pose2> RunRecord::worldFromMap() const {
  for (std::size_t node = 0; node < graph_stamps_.size(); ++node) {
    if (const auto T_world_node = truth_.at(graph_stamps_[node])) {
      return *T_world_node * graph_.poses[node].inverse();
    }
  }
  return std::nullopt;
}

std::optional<double> RunRecord::poseError(const geometry::StampedPose2& T_map_base) const {
  const auto T_world_map = worldFromMap();
  const auto T_world_base = truth_.at(T_map_base.stamp);
  if (!T_world_map || !T_world_base) {
    return std::nullopt;
  }
  return geometry::distance(*T_world_map * T_map_base.pose, *T_world_base);
}

std::size_t RunRecord::loops() const {
  return static_cast<std::size_t>(
      std::count_if(graph_.constraints.begin(), graph_.constraints.end(),
                    [](const graph::Constraint& constraint) {
                      return constraint.kind == graph::ConstraintKind::kLoop;
                    }));
}

void RunRecord::advance(double stamp) {
  oldest_ = started_ ? oldest_ : stamp;
  newest_ = started_ ? std::max(newest_, stamp) : stamp;
  started_ = true;
}

}  // namespace omega_slam
