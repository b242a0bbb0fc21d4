#include "omega_slam/graph/chordal_relaxation.h"

#include <cmath>
#include <optional>
#include <vector>

#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// (cos, sin) of the heading of `to` less that of `from` turned by the measured angle. The third
/// row, which says that a number that nobody uses is the same at both, fills the block.
LinearizedConstraint headingConstraint(const Constraint& constraint, const PoseGraph& graph) {
  const Eigen::Matrix2d turn = constraint.T_from_to.rotation();
  const auto unit = [&](NodeId node) -> Eigen::Vector2d {
    return graph.poses[node].rotation().col(0);
  };
  LinearizedConstraint result;
  result.J_to.setIdentity();
  result.J_from = -Eigen::Matrix3d::Identity();
  result.J_from.topLeftCorner<2, 2>() = -turn;
  result.error << unit(constraint.to) - turn * unit(constraint.from), 0.0;
  return result;
}

/// The usual error, with headings that do not move.
LinearizedConstraint positionConstraint(const Constraint& constraint, const PoseGraph& graph) {
  LinearizedConstraint result = linearize(constraint, graph);
  result.J_from.topRightCorner<2, 1>().setZero();
  result.error[2] = 0.0;
  return result;
}

Eigen::Matrix3d headingInformation(const Constraint& constraint) {
  // A constraint that says nothing of headings still has to tie its block down.
  constexpr double kLeast = 1e-9;
  return std::max(constraint.information(2, 2), kLeast) * Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d positionInformation(const Constraint& constraint) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  information.topLeftCorner<2, 2>() = constraint.information.topLeftCorner<2, 2>();
  return information;
}

template <typename Linearize, typename Weigh>
std::optional<Eigen::VectorXd> solveLinear(GraphSystem& system, const PoseGraph& graph,
                                           Linearize linearize_one, Weigh weigh) {
  system.form().clear();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const Constraint& constraint = graph.constraints[k];
    system.form().add(k, linearize_one(constraint, graph), weigh(constraint));
  }
  return system.solve();
}

}  // namespace

void relaxChordally(PoseGraph& graph) {
  if (graph.constraints.empty()) {
    return;
  }
  const std::vector<Pose2> before = graph.poses;
  GraphSystem system;
  system.prepare(graph, spanningForest(graph).roots);
  const auto turns = solveLinear(system, graph, headingConstraint, headingInformation);
  if (!turns) {
    return;
  }
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    const Eigen::Vector2d heading =
        graph.poses[i].rotation().col(0) + turns->segment<2>(3 * static_cast<Eigen::Index>(i));
    graph.poses[i].theta = std::atan2(heading.y(), heading.x());
  }
  for (const NodeId point : graph.points) {
    graph.poses[point].theta = before[point].theta;
  }
  const auto steps = solveLinear(system, graph, positionConstraint, positionInformation);
  if (!steps) {
    graph.poses = before;
    return;
  }
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    graph.poses[i].x += (*steps)[3 * static_cast<Eigen::Index>(i)];
    graph.poses[i].y += (*steps)[3 * static_cast<Eigen::Index>(i) + 1];
  }
}

}  // namespace omega_slam::graph
