#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/incremental_solver.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/retired_nodes.h"
#include "omega_slam/graph/robust_loops.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/thinning.h"
#include "omega_slam/slam/doubt.h"

namespace omega_slam::slam {

struct BackEndConfig {
  graph::IncrementalConfig graph;
  /// The graph is solved until it rests when a loop lies off by more than so many standard
  /// deviations.
  double solve_error{1.0};
  /// When a loop lies off by more than `doubt.gate` in the solved graph, all loops are doubted.
  graph::RobustConfig doubt;
  /// Which keyframes retire, so that the graph grows with the area that is driven and not with the
  /// time. Its kernels do not matter: they are those of `graph`.
  graph::ThinningConfig thinning{0.5, 0.5, 20, 50, 1.0, graph::kPlain};

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// How far the constraints of a graph are believed.
struct BeliefAccount {
  std::vector<double> weights;  ///< [0, 1] of each of the graph; empty where nobody knows
  std::vector<graph::Constraint> withdrawn;  ///< loops that are no part of the graph any more
  /// Loops that went with keyframes which have retired: they count in what was put in their place.
  std::vector<graph::Constraint> folded{};
};

/// Holds the graph, keeps it solved, and says where the odometry frame lies in the map.
///
/// Loops may be false. As long as no loop lies far off once the graph is solved, nothing speaks
/// against any. Else those that the rest contradicts are withdrawn (graph/robust_loops.h), and come
/// back if the next doubt finds them right. What would fit by accident stays: the front end has
/// gates of its own. A loop that was let be, far off though it is, calls for no other doubt until
/// it has got much worse: the answer would be the same. In a large graph, where a doubt takes long,
/// loops that call for one are withdrawn until it is over: it goes on by one step with each new
/// keyframe, not too soon after the last, or at once when solve() is called. Not thread-safe: one
/// owner calls it.
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

  /// Adds constraints between known nodes, the bad ones excepted. All poses follow.
  /// @return why the first bad one was refused, a short stable phrase; or empty
  std::string addConstraints(const std::vector<graph::Constraint>& constraints);

  /// Solves the whole graph until it rests, without the loops that are then withdrawn.
  const graph::SolveReport& solve();

  /// Keyframe i is node i. Those that have retired are held, have no constraints, and go with
  /// their anchors.
  [[nodiscard]] const graph::PoseGraph& graph() const { return solver_.graph(); }
  [[nodiscard]] std::size_t retired() const { return retired_.size(); }  ///< keyframes
  /// Of the last solve of the whole graph.
  [[nodiscard]] const graph::SolveReport& report() const { return report_; }
  /// Loops that the rest contradicts; they are no part of the graph.
  [[nodiscard]] const std::vector<graph::Constraint>& withdrawn() const { return withdrawn_; }
  /// BeliefAccount::folded
  [[nodiscard]] const std::vector<graph::Constraint>& folded() const { return folded_; }

  /// At the present poses, by the kernels.
  [[nodiscard]] BeliefAccount beliefs() const;
  [[nodiscard]] std::size_t doubts() const { return doubts_; }  ///< times that all were doubted

  /// `T_map_odom = T_map_base * T_odom_base^-1` at the newest keyframe; the identity while there is
  /// none.
  [[nodiscard]] geometry::Pose2 mapFromOdometry() const;

  void reset();

 private:
  [[nodiscard]] bool isAnyLoopFarOff() const;
  /// Squared error beyond which a loop calls for a doubt. @param k index of the constraint
  [[nodiscard]] double limitOf(std::size_t k) const;
  [[nodiscard]] bool isLarge() const;
  void addUndoubted(const std::vector<graph::Constraint>& loops);
  void beginDoubt();
  void goOnDoubting();
  void concludeDoubt();
  void letBe();
  void retireSome();
  void moveRetired();

  BackEndConfig config_;
  graph::IncrementalSolver solver_;
  geometry::Pose2 T_odom_newest_;
  graph::SolveReport report_;
  std::vector<graph::Constraint> withdrawn_;
  std::vector<graph::Constraint> folded_;
  std::size_t doubts_{0};
  std::size_t doubted_at_{0};         ///< keyframes that there were at the last doubt
  bool is_doubt_called_{false};       ///< by loops that were withdrawn until then
  std::optional<Doubt> doubt_;        ///< that goes on
  std::optional<LoopSet> confirmed_;  ///< by the last doubt; none where it found no answer
  /// Squared errors of the constraints after the last doubt; those that came since are not in it.
  std::vector<double> let_be_;
  graph::RetiredNodes retired_;
  std::size_t looked_at_{0};  ///< keyframes that there were when some were last sought to retire
};

}  // namespace omega_slam::slam
