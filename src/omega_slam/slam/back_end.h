#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/solver.h"

namespace omega_slam::slam {

struct BackEndConfig {
  graph::SolverConfig solver;
  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Holds the graph, keeps it solved, and says where the odometry frame lies in the map.
/// Not thread-safe: one owner calls it.
class BackEnd {
 public:
  explicit BackEnd(const BackEndConfig& config = {});  ///< @throws std::invalid_argument

  /// Adds node `id` with its constraints to earlier nodes; its first pose follows from the most
  /// informative of them. The first node lies at the origin of the map.
  /// @return why it was refused (id out of turn, pose not finite, no valid constraint to what is
  /// there), or an empty string
  std::string addKeyframe(graph::NodeId id, const geometry::Pose2& T_odom_base,
                          const std::vector<graph::Constraint>& constraints);

  /// Adds constraints between known nodes. @return why the first bad one was refused, or an empty
  /// string; good ones are kept
  std::string addConstraints(const std::vector<graph::Constraint>& constraints);

  /// Solves if something new has come that can move a node; else returns the last report.
  const graph::SolveReport& solve();

  [[nodiscard]] const graph::PoseGraph& graph() const { return graph_; }
  [[nodiscard]] const graph::SolveReport& report() const { return report_; }
  /// `T_map_base * T_odom_base^-1` at the newest keyframe; the identity while there is none.
  [[nodiscard]] geometry::Pose2 mapFromOdometry() const;
  void reset();

 private:
  BackEndConfig config_;
  graph::PoseGraph graph_;
  geometry::Pose2 T_odom_newest_;
  graph::SolveReport report_;
  bool dirty_{false};
};

}  // namespace omega_slam::slam
