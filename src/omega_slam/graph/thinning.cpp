#include "omega_slam/graph/thinning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::graph {

using geometry::Pose2;

namespace {

/// Which nodes are where others are. They are found by the square that they lie in, as wide as a
/// place.
class Places {
 public:
  Places(const PoseGraph& graph, const ThinningConfig& config) : graph_(graph), config_(config) {
    std::vector<bool> is_tied(graph.poses.size(), false);
    for (const Constraint& constraint : graph.constraints) {
      is_tied[constraint.from] = is_tied[constraint.to] = true;
    }
    for (NodeId node = 0; node < is_tied.size(); ++node) {
      if (is_tied[node]) {
        tied_.push_back(node);
        nodes_[squareOf(graph.poses[node])].push_back(node);
      }
    }
  }

  /// Nodes that may go, those that are tied to something: what is not was taken out before. Never
  /// the first of the graph, nor the newest.
  [[nodiscard]] std::vector<NodeId> candidates() const {
    std::vector<NodeId> nodes;
    for (const NodeId node : tied_) {
      if (node > 0 && node + static_cast<std::size_t>(config_.newest) < graph_.poses.size()) {
        nodes.push_back(node);
      }
    }
    return nodes;
  }

  /// Whether there are enough later nodes where a node is.
  [[nodiscard]] bool isCrowded(NodeId node) const {
    const auto [column, row] = squareOf(graph_.poses[node]);
    std::ptrdiff_t later_here = 0;
    for (const double x : {column - 1.0, column, column + 1.0}) {
      for (const double y : {row - 1.0, row, row + 1.0}) {
        later_here += laterIn({x, y}, node);
      }
    }
    return later_here >= config_.nodes_per_place;
  }

 private:
  using Square = std::pair<double, double>;

  [[nodiscard]] Square squareOf(const Pose2& pose) const {
    return {std::floor(pose.x / config_.spacing), std::floor(pose.y / config_.spacing)};
  }

  [[nodiscard]] std::ptrdiff_t laterIn(const Square& square, NodeId node) const {
    const auto found = nodes_.find(square);
    if (found == nodes_.end()) {
      return 0;
    }
    const std::vector<NodeId>& here = found->second;  // in their order
    return std::count_if(
        std::upper_bound(here.begin(), here.end(), node), here.end(),
        [&](NodeId other) { return isAt(graph_.poses[node], graph_.poses[other]); });
  }

  [[nodiscard]] bool isAt(const Pose2& pose, const Pose2& other) const {
    return geometry::distance(pose, other) < config_.spacing &&
           std::abs(geometry::angleDifference(pose.theta, other.theta)) < config_.turn;
  }

  const PoseGraph& graph_;
  const ThinningConfig& config_;
  std::vector<NodeId> tied_;  ///< ascending
  std::map<Square, std::vector<NodeId>> nodes_;
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
  const std::vector<NodeId> candidates = places.candidates();
  return std::any_of(candidates.begin(), candidates.end(),
                     [&places](NodeId node) { return places.isCrowded(node); });
}

std::vector<Retirement> retireNodes(PoseGraph& graph, const ThinningConfig& config) {
  geometry::throwIfAny(config.validate());
  std::vector<Retirement> retired;
  if (config.nodes_per_place == 0) {
    return retired;
  }
  const Places places(graph, config);
  for (const NodeId node : places.candidates()) {
    const auto retirement = places.isCrowded(node)
                                ? retireNode(graph, node, config.max_divergence, config.kernels)
                                : std::nullopt;
    if (retirement) {
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
