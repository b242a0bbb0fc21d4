#include "support/graph_file_laws.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/graph_file.h"

namespace omega_slam::test {
namespace {

using geometry::Pose2;
using graph::Constraint;
using graph::GraphFile;
using graph::NodeId;
using graph::PoseGraph;

const std::string kName = "fuzzed.g2o";

/// Thrown by the checks here, and only by them.
struct BrokenLaw {
  std::string what;
};

void require(bool holds, const std::string& what) {
  if (!holds) {
    throw BrokenLaw{what};
  }
}

bool isGood(const Pose2& pose) {
  return pose.isFinite() && pose.theta >= -geometry::kPi && pose.theta < geometry::kPi;
}

/// As the readers promise, which forgive rounding in the file.
bool isGood(const Eigen::Matrix3d& information) {
  if (!information.allFinite() || information != information.transpose()) {
    return false;
  }
  const Eigen::Vector3d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return eigenvalues[0] >= -1e-6 * std::abs(eigenvalues[2]);
}

bool areNodes(const std::vector<NodeId>& nodes, std::size_t count) {
  return std::set<NodeId>(nodes.begin(), nodes.end()).size() == nodes.size() &&
         std::all_of(nodes.begin(), nodes.end(), [&](NodeId node) { return node < count; });
}

void requireConstraint(const Constraint& constraint, const PoseGraph& graph,
                       const std::vector<bool>& is_point) {
  require(constraint.from < graph.poses.size() && constraint.to < graph.poses.size() &&
              constraint.from != constraint.to,
          "a constraint ties two nodes of the graph");
  require(isGood(constraint.T_from_to), "a constraint's pose is finite, its angle in [-pi, pi)");
  require(isGood(constraint.information),
          "information is finite, symmetric and positive semi-definite");
  const bool is_sight = constraint.kind == graph::ConstraintKind::kLandmark;
  require(!is_point[constraint.from] && is_point[constraint.to] == is_sight,
          "points are what landmark constraints lead to, and nothing else");
}

void requireConsistent(const GraphFile& file) {
  const PoseGraph& graph = file.graph;
  require(file.ids.size() == graph.poses.size(), "every node has an id");
  require(std::adjacent_find(file.ids.begin(), file.ids.end(), std::greater_equal<>()) ==
              file.ids.end(),
          "ids ascend");
  require(areNodes(graph.held, graph.poses.size()), "held nodes are in the graph, each once");
  require(areNodes(graph.points, graph.poses.size()), "points are in the graph, each once");
  std::vector<bool> is_point(graph.poses.size(), false);
  for (const NodeId point : graph.points) {
    is_point[point] = true;
    require(graph.poses[point].theta == 0.0, "points have no heading");
  }
  require(std::all_of(graph.poses.begin(), graph.poses.end(),
                      [](const Pose2& pose) { return isGood(pose); }),
          "poses are finite, their angles in [-pi, pi)");
  for (const Constraint& constraint : graph.constraints) {
    requireConstraint(constraint, graph, is_point);
  }
}

bool areSame(const Constraint& a, const Constraint& b) {
  return a.from == b.from && a.to == b.to && a.kind == b.kind &&
         a.T_from_to.vector() == b.T_from_to.vector() && a.information == b.information;
}

void requireSame(const GraphFile& file, const GraphFile& again, const std::string& format) {
  require(again.ids == file.ids, format + " keeps the ids");
  require(again.graph.points == file.graph.points, format + " keeps the points");
  require(std::equal(file.graph.poses.begin(), file.graph.poses.end(), again.graph.poses.begin(),
                     again.graph.poses.end(),
                     [](const Pose2& a, const Pose2& b) { return a.vector() == b.vector(); }),
          format + " keeps the poses");
  require(std::equal(file.graph.constraints.begin(), file.graph.constraints.end(),
                     again.graph.constraints.begin(), again.graph.constraints.end(), areSame),
          format + " keeps the constraints");
}

void requireRoundTrips(const GraphFile& file) {
  const std::string text = graph::toG2o(file);
  const GraphFile again = graph::readGraph(text, "again.g2o");
  requireSame(file, again, "g2o");
  // A graph that holds no node holds the first, and says so.
  const bool holds_first = file.graph.held.empty() && !file.graph.poses.empty();
  require(again.graph.held == (holds_first ? std::vector<NodeId>{0} : file.graph.held),
          "g2o keeps the held nodes");
  require(graph::toG2o(again) == text, "equal graphs give equal text");
  if (file.graph.points.empty()) {
    requireSame(file, graph::readGraph(graph::toToro(file), "again.graph"), "TORO");
  }
}

void requireReadable(const std::string& complaint) {
  require(complaint.rfind(kName, 0) == 0, "a complaint names the file: " + complaint);
  require(complaint.size() < 300, "a complaint is short: " + complaint);
  require(
      std::all_of(complaint.begin(), complaint.end(), [](char c) { return c >= 32 && c < 127; }),
      "a complaint is printable: " + complaint);
}

/// Nothing where reading ended in a complaint, as it should for most texts.
std::optional<GraphFile> read(const std::string& text) {
  try {
    return graph::readGraph(text, kName);
  } catch (const std::runtime_error& error) {
    requireReadable(error.what());
  }
  return std::nullopt;
}

}  // namespace

std::string brokenLawOfReading(const std::string& text) {
  try {
    if (const auto file = read(text)) {
      requireConsistent(*file);
      requireRoundTrips(*file);
    }
  } catch (const BrokenLaw& broken) {
    return broken.what;
  } catch (const std::exception& error) {
    return fmt::format("what was written can be read again: {}", error.what());
  }
  return {};
}

}  // namespace omega_slam::test
