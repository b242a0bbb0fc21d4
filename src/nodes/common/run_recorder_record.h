#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/slam/back_end.h"
#include "omega_slam/slam/scan_trajectory.h"

namespace omega_slam {

/// Everything that is kept of a run until it is saved, and what follows from it. The world's frame
/// is that of the ground truth; the map's frame begins at the first keyframe.
class RunRecord {
 public:
  void addOdometry(double stamp, const geometry::Pose2& T_odom_base);
  void addTruth(double stamp, const geometry::Pose2& T_world_base);
  void addScan(double stamp);
  /// @param run that its keyframe belongs to; tracks of the run before are forgotten
  void addTrack(std::uint64_t run, const slam::ScanTrack& track);
  /// @param id of the keyframe in its run: 0, 1, 2, ...
  void addKeyframe(graph::NodeId id, double stamp);
  /// @param stamps [s] of the graph's nodes; as many as it has poses
  void setGraph(graph::PoseGraph graph, std::vector<double> stamps,
                slam::BeliefAccount beliefs = {});
  /// @param stamp [s] of the newest keyframe that is drawn
  void setMap(grid::OccupancyGrid map, double stamp);
  void clear() { *this = RunRecord(); }

  /// `T_map_base` at each scan that was tracked, in the order of the scans.
  [[nodiscard]] geometry::Trajectory estimate() const;
  /// `T_world_base` at each scan.
  [[nodiscard]] geometry::Trajectory truth() const;
  /// `T_odom_base` at each scan.
  [[nodiscard]] geometry::Trajectory odometry() const;
  /// `T_world_map`, by the ground truth at the first keyframe for which there is any.
  [[nodiscard]] std::optional<geometry::Pose2> worldFromMap() const;
  /// Distance [m] of a tracked pose from the ground truth at its time.
  [[nodiscard]] std::optional<double> poseError(const geometry::StampedPose2& T_map_base) const;

  [[nodiscard]] const graph::PoseGraph& graph() const { return graph_; }
  [[nodiscard]] const slam::BeliefAccount& beliefs() const { return beliefs_; }
  [[nodiscard]] const std::vector<double>& graphStamps() const { return graph_stamps_; }
  [[nodiscard]] const grid::OccupancyGrid& map() const { return map_; }
  [[nodiscard]] double mapStamp() const { return map_stamp_; }  ///< [s]; 0 while there is no map
  [[nodiscard]] double distance() const { return distance_; }   ///< [m] truly driven
  [[nodiscard]] double elapsed() const { return newest_ - oldest_; }  ///< [s] of the run's clock
  [[nodiscard]] double newest() const { return newest_; }             ///< [s] newest stamp
  [[nodiscard]] std::size_t scans() const { return scan_stamps_.size(); }
  [[nodiscard]] std::size_t keyframes() const { return keyframes_; }
  [[nodiscard]] std::size_t loops() const;

 private:
  void advance(double stamp);

  motion::OdometryBuffer odometry_{kForever};
  motion::OdometryBuffer truth_{kForever};
  std::vector<double> scan_stamps_;
  std::vector<slam::ScanTrack> tracks_;
  std::uint64_t run_{0};  ///< of the tracks
  std::size_t keyframes_{0};
  graph::PoseGraph graph_;
  slam::BeliefAccount beliefs_;
  std::vector<double> graph_stamps_;
  grid::OccupancyGrid map_;
  double map_stamp_{0.0};
  double distance_{0.0};
  bool started_{false};
  double oldest_{0.0};
  double newest_{0.0};

  static constexpr double kForever{1e12};  ///< [s]: nothing is forgotten
};

}  // namespace omega_slam
