#include "omega_slam/graph/thinning.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// Which nodes are where others are.
class Places {
 public:
  Places(const PoseGraph& graph, const ThinningConfig& config) : graph_(graph), config_(config) {
    is_tied_.assign(graph.poses.size(), false);
    for (const Constraint& constraint : graph.constraints) {
      is_tied_[constraint.from] = is_tied_[constraint.to] = true;
    }
  }

  /// Whether there are enough later nodes where a node is.
  [[nodiscard]] bool isCrowded(std::size_t node) const {
    int later_here = 0;
    for (std::size_t other = node + 1; is_tied_[node] && other < is_tied_.size(); ++other) {
      later_here += isAt(graph_.poses[node], other) ? 1 : 0;
      if (later_here >= config_.nodes_per_place) {
        return true;
      }
    }
    return false;
  }

  void untie(std::size_t node) { is_tied_[node] = false; }

 private:
  [[nodiscard]] bool isAt(const Pose2& pose, std::size_t node) const {
    const Pose2& other = graph_.poses[node];
    return is_tied_[node] && geometry::distance(pose, other) < config_.spacing &&
           std::abs(geometry::angleDifference(pose.theta, other.theta)) < config_.turn;
  }

  const PoseGraph& graph_;
  const ThinningConfig& config_;
  std::vector<bool> is_tied_;  ///< by node: what is tied to nothing was taken out before
};

}  // namespace

std::vector<std::string> ThinningConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("spacing", spacing, 0.0);
  violations.requireAbove("turn", turn, 0.0);
  violations.requireAtLeast("nodes_per_place", nodes_per_place, 0);
  violations.requireAtLeast("newest", newest, 0);
  violations.requireAtLeast("max_divergence", max_divergence, 0.0);
  return violations.sentences();
}

bool isAnyCrowded(const PoseGraph& graph, const ThinningConfig& config) {
  const Places places(graph, config);
  const auto newest = static_cast<std::size_t>(config.newest);
  for (std::size_t node = 1; node + newest < graph.poses.size(); ++node) {
    if (places.isCrowded(node)) {
      return true;
    }
  }
  return false;
}

std::vector<Retirement> retireNodes(PoseGraph& graph, const ThinningConfig& config) {
  geometry::throwIfAny(config.validate());
  std::vector<Retirement> retired;
  if (config.nodes_per_place == 0) {
    return retired;
  }
  Places places(graph, config);
  const auto newest = static_cast<std::size_t>(config.newest);
  for (std::size_t node = 1; node + newest < graph.poses.size(); ++node) {
    const auto retirement =
        places.isCrowded(node)
            ? retireNode(graph, static_cast<NodeId>(node), config.max_divergence, config.kernels)
            : std::nullopt;
    if (retirement) {
      places.untie(node);
      retired.push_back(*retirement);
    }
  }
  return retired;
}

ThinningReport thinOut(PoseGraph& graph, const ThinningConfig& config) {
  ThinningReport report;
  const std::vector<NodeId> held = graph.held;
  std::vector<NodeId> nodes;
  for (const Retirement& retirement : retireNodes(graph, config)) {
    nodes.push_back(retirement.node);
    report.divergence += retirement.divergence;
  }
  for (NodeId node = 0; node < graph.poses.size(); ++node) {
    if (!std::binary_search(nodes.begin(), nodes.end(), node)) {
      report.kept.push_back(node);
    }
  }
  graph.held = held;
  eraseNodes(graph, nodes);
  return report;
}

}  // namespace omega_slam::graph
