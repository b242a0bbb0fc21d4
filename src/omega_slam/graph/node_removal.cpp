#include "omega_slam/graph/node_removal.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "omega_slam/graph/linearization.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// What the constraints of a node say of its neighbours together, the node itself marginalised, the
/// first neighbour held.
struct Marginal {
  std::vector<NodeId> neighbours;
  Eigen::MatrixXd covariance;  ///< of all neighbours; zero for the first
  Eigen::VectorXd shift;       ///< from the graph's poses to the mean
};

/// Those that a node has. All that is asked of them is asked of these few, for a graph is long to
/// look through.
std::vector<Constraint> constraintsOf(const PoseGraph& graph, NodeId node) {
  std::vector<Constraint> own;
  std::copy_if(graph.constraints.begin(), graph.constraints.end(), std::back_inserter(own),
               [node](const Constraint& c) { return c.from == node || c.to == node; });
  return own;
}

/// @param own constraints of the node
std::vector<NodeId> neighboursOf(const std::vector<Constraint>& own, NodeId node) {
  std::vector<NodeId> neighbours;
  for (const Constraint& constraint : own) {
    neighbours.push_back(constraint.from == node ? constraint.to : constraint.from);
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return neighbours;
}

/// The marginal, or none where the constraints do not determine it.
std::optional<Marginal> marginalOf(const PoseGraph& graph, NodeId node,
                                   const std::vector<Constraint>& own,
                                   const KernelConfig& kernels) {
  Marginal marginal{neighboursOf(own, node), {}, {}};
  const auto count = static_cast<Eigen::Index>(marginal.neighbours.size());
  Eigen::MatrixXd omega = Eigen::MatrixXd::Zero(3 * (count + 1), 3 * (count + 1));
  Eigen::VectorXd xi = Eigen::VectorXd::Zero(3 * (count + 1));
  const auto rowOf = [&](NodeId id) {  // the node's own comes last
    const auto found = std::lower_bound(marginal.neighbours.begin(), marginal.neighbours.end(), id);
    return 3 * (id == node ? count : found - marginal.neighbours.begin());
  };
  for (const Constraint& constraint : own) {
    const LinearizedConstraint at = linearize(constraint, graph);
    const double weight = kernels.of(constraint.kind).at(chiSquare(graph, constraint)).weight;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, omega.cols());
    jacobian.middleCols<3>(rowOf(constraint.from)) = at.J_from;
    jacobian.middleCols<3>(rowOf(constraint.to)) = at.J_to;
    const Eigen::MatrixXd weighted = weight * jacobian.transpose() * constraint.information;
    omega += weighted * jacobian;
    xi -= weighted * at.error;
  }
  // With the first neighbour held, the rest and the node itself have a covariance; that of the
  // rest is a block of it.
  const Eigen::Index free = 3 * count;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(omega.bottomRightCorner(free, free));
  if (cholesky.info() != Eigen::Success) {
    return std::nullopt;
  }
  const Eigen::MatrixXd covariance = cholesky.solve(Eigen::MatrixXd::Identity(free, free));
  const Eigen::VectorXd shift = cholesky.solve(xi.tail(free));
  const Eigen::Index kept = free - 3;
  marginal.covariance = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  marginal.covariance.bottomRightCorner(kept, kept) = covariance.topLeftCorner(kept, kept);
  marginal.shift = Eigen::VectorXd::Zero(3 * count);
  marginal.shift.tail(kept) = shift.head(kept);
  return marginal.covariance.allFinite() ? std::make_optional(marginal) : std::nullopt;
}

/// Covariance of the pose of neighbour b seen from a, in the axes of `a`.
Eigen::Matrix3d relativeCovariance(const PoseGraph& graph, const Marginal& marginal, Eigen::Index a,
                                   Eigen::Index b) {
  Constraint unturned;
  unturned.from = marginal.neighbours[static_cast<std::size_t>(a)];
  unturned.to = marginal.neighbours[static_cast<std::size_t>(b)];
  const LinearizedConstraint at = linearize(unturned, graph);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, marginal.covariance.cols());
  jacobian.middleCols<3>(3 * a) = at.J_from;
  jacobian.middleCols<3>(3 * b) = at.J_to;
  return jacobian * marginal.covariance * jacobian.transpose();
}

double logDeterminant(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd lower = Eigen::LLT<Eigen::MatrixXd>(matrix).matrixL();
  return 2.0 * lower.diagonal().array().log().sum();
}

struct Edge {
  Eigen::Index a;
  Eigen::Index b;
  Eigen::Matrix3d covariance;
  double log_determinant;
};

/// The tree of neighbours whose relative poses are known best: least sum of log-determinants
/// (Prim's algorithm).
std::vector<Edge> bestTree(const PoseGraph& graph, const Marginal& marginal) {
  const auto count = static_cast<Eigen::Index>(marginal.neighbours.size());
  std::vector<bool> is_in(static_cast<std::size_t>(count), false);
  is_in[0] = true;
  std::vector<Edge> tree;
  while (static_cast<Eigen::Index>(tree.size()) < count - 1) {
    Edge best{0, 0, {}, std::numeric_limits<double>::infinity()};
    for (Eigen::Index a = 0; a < count; ++a) {
      for (Eigen::Index b = 0; b < count; ++b) {
        if (!is_in[static_cast<std::size_t>(a)] || is_in[static_cast<std::size_t>(b)]) {
          continue;
        }
        const Eigen::Matrix3d covariance = relativeCovariance(graph, marginal, a, b);
        const double log_determinant = logDeterminant(covariance);
        if (log_determinant < best.log_determinant) {
          best = {a, b, covariance, log_determinant};
        }
      }
    }
    if (!std::isfinite(best.log_determinant)) {
      return {};
    }
    is_in[static_cast<std::size_t>(best.b)] = true;
    tree.push_back(best);
  }
  return tree;
}

/// What the tree's edges know of each other, which constraints of their own can't say.
double divergenceOf(const std::vector<Edge>& tree, const Marginal& marginal) {
  const Eigen::Index kept = marginal.covariance.cols() - 3;
  const double edges =
      std::accumulate(tree.begin(), tree.end(), 0.0,
                      [](double sum, const Edge& edge) { return sum + edge.log_determinant; });
  return 0.5 * (edges - logDeterminant(marginal.covariance.bottomRightCorner(kept, kept)));
}

Constraint constraintOf(const PoseGraph& graph, const Marginal& marginal, const Edge& edge) {
  const auto meanOf = [&](Eigen::Index i) {
    const NodeId id = marginal.neighbours[static_cast<std::size_t>(i)];
    return Pose2::fromVector(graph.poses[id].vector() + marginal.shift.segment<3>(3 * i));
  };
  Constraint constraint;
  constraint.from = marginal.neighbours[static_cast<std::size_t>(edge.a)];
  constraint.to = marginal.neighbours[static_cast<std::size_t>(edge.b)];
  constraint.kind = ConstraintKind::kMatch;
  constraint.T_from_to = relativePose(meanOf(edge.a), meanOf(edge.b));
  // From the axes of `from` to those of the measurement.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = constraint.T_from_to.rotation();
  const Eigen::Matrix3d information = turn.transpose() * edge.covariance.inverse() * turn;
  constraint.information = 0.5 * (information + information.transpose());
  return constraint;
}

bool isFixture(const PoseGraph& graph, NodeId node, const std::vector<Constraint>& own) {
  const auto contains = [](const std::vector<NodeId>& nodes, NodeId id) {
    return std::find(nodes.begin(), nodes.end(), id) != nodes.end();
  };
  return contains(graph.held, node) || contains(graph.points, node) ||
         std::any_of(own.begin(), own.end(), [&](const Constraint& c) {
           return c.from == node && c.kind == ConstraintKind::kLandmark;
         });
}

/// Replaces the constraints of a node by others between its neighbours. @return what is lost by
/// that; none, and the graph as it was, in the cases of removeNode()
std::optional<double> untie(PoseGraph& graph, NodeId node, const std::vector<Constraint>& own,
                            double max_divergence, const KernelConfig& kernels) {
  if (own.empty() || isFixture(graph, node, own)) {
    return std::nullopt;
  }
  const auto marginal = marginalOf(graph, node, own, kernels);
  if (!marginal) {
    return std::nullopt;
  }
  std::vector<Constraint> replacements;
  double divergence = 0.0;
  if (marginal->neighbours.size() > 1) {
    const std::vector<Edge> tree = bestTree(graph, *marginal);
    divergence = divergenceOf(tree, *marginal);
    if (tree.empty() || !(divergence <= max_divergence)) {
      return std::nullopt;
    }
    for (const Edge& edge : tree) {
      replacements.push_back(constraintOf(graph, *marginal, edge));
    }
  }
  auto& constraints = graph.constraints;
  constraints.erase(
      std::remove_if(constraints.begin(), constraints.end(),
                     [node](const Constraint& c) { return c.from == node || c.to == node; }),
      constraints.end());
  constraints.insert(constraints.end(), replacements.begin(), replacements.end());
  return std::max(divergence, 0.0);
}

}  // namespace

void eraseNodes(PoseGraph& graph, const std::vector<NodeId>& nodes) {
  std::vector<bool> is_kept(graph.poses.size(), true);
  for (const NodeId node : nodes) {
    is_kept[node] = false;
  }
  std::vector<NodeId> new_index(graph.poses.size());
  NodeId kept = 0;
  for (std::size_t node = 0; node < is_kept.size(); ++node) {
    graph.poses[kept] = graph.poses[node];
    new_index[node] = kept;
    kept += is_kept[node] ? 1 : 0;
  }
  graph.poses.resize(kept);
  const auto move = [&](NodeId& id) { id = new_index[id]; };
  for (Constraint& constraint : graph.constraints) {
    move(constraint.from);
    move(constraint.to);
  }
  std::for_each(graph.held.begin(), graph.held.end(), move);
  std::for_each(graph.points.begin(), graph.points.end(), move);
}

std::optional<double> removeNode(PoseGraph& graph, NodeId node, double max_divergence,
                                 const KernelConfig& kernels) {
  const auto lost = untie(graph, node, constraintsOf(graph, node), max_divergence, kernels);
  if (lost) {
    eraseNodes(graph, {node});
  }
  return lost;
}

std::optional<Retirement> retireNode(PoseGraph& graph, NodeId node, double max_divergence,
                                     const KernelConfig& kernels) {
  const std::vector<Constraint> own = constraintsOf(graph, node);
  const std::vector<NodeId> neighbours = neighboursOf(own, node);
  const auto lost = untie(graph, node, own, max_divergence, kernels);
  if (!lost) {
    return std::nullopt;
  }
  const Pose2& pose = graph.poses[node];
  const NodeId anchor =
      *std::min_element(neighbours.begin(), neighbours.end(), [&](NodeId a, NodeId b) {
        return geometry::distance(graph.poses[a], pose) < geometry::distance(graph.poses[b], pose);
      });
  if (graph.held.empty()) {
    graph.held.push_back(0);  // as is understood
  }
  graph.held.push_back(node);
  return Retirement{node, anchor, geometry::relativePose(graph.poses[anchor], pose), *lost};
}

}  // namespace omega_slam::graph
