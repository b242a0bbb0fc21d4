#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/solver.h"

namespace omega_slam::slam {

struct BackEndConfig {
  graph::SolverConfig solver;
  double solve_error{
      1.0};  ///< solve at once when a loop lies off by more than so many standard deviations,
  int solve_interval{10};  ///< else when so many keyframes have come since the first unsolved loop

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Holds the graph, keeps it solved, and says where the odometry frame lies in the map.
/// Not thread-safe: one owner calls it.
class BackEnd {
 public:
  explicit BackEnd(const BackEndConfig& config = {});  ///< @throws std::invalid_argument

  /// Adds node `id` with its constraints to earlier nodes, at the pose that these make most likely:
  /// the optimum, since a new leaf moves nothing else. The first node lies at the origin of the map
  /// and needs no constraint.
  /// @return why it was refused (id out of turn, pose not finite, no valid constraint), a short
  /// stable phrase; or empty
  std::string addKeyframe(graph::NodeId id, const geometry::Pose2& T_odom_base,
                          const std::vector<graph::Constraint>& constraints);

  /// Adds constraints between known nodes, the bad ones excepted.
  /// @return why the first bad one was refused, a short stable phrase; or empty
  std::string addConstraints(const std::vector<graph::Constraint>& constraints);

  /// Whether what has come since the last solve is worth one (see the config).
  [[nodiscard]] bool wantsSolve() const;

  /// Solves the whole graph.
  const graph::SolveReport& solve();

  [[nodiscard]] const graph::PoseGraph& graph() const { return graph_; }
  [[nodiscard]] const graph::SolveReport& report() const { return report_; }  ///< of the last solve

  /// `T_map_odom = T_map_base * T_odom_base^-1` at the newest keyframe; the identity while there is
  /// none.
  [[nodiscard]] geometry::Pose2 mapFromOdometry() const;

  void reset();

 private:
  BackEndConfig config_;
  graph::PoseGraph graph_;
  geometry::Pose2 T_odom_newest_;
  graph::SolveReport report_;
  double unsolved_error_{
      0.0};  ///< largest error of a constraint not yet solved for [standard deviations]
  std::size_t unsolved_since_{0};  ///< count of nodes when the first such constraint came
  bool unsolved_{false};
};

}  // namespace omega_slam::slam
