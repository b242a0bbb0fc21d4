#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

#include "omega_slam/graph/graph_file.h"

namespace omega_slam::graph {
namespace {

using Text = std::back_insert_iterator<fmt::memory_buffer>;

/// What each node of a file is called, and whether it is a point.
struct Names {
  explicit Names(const GraphFile& file) : ids(file.ids), is_point(file.graph.poses.size(), false) {
    for (std::size_t node = ids.size(); node < file.graph.poses.size(); ++node) {
      ids.push_back(static_cast<NodeId>(node));
    }
    for (const NodeId point : file.graph.points) {
      is_point[point] = true;
    }
  }

  std::vector<NodeId> ids;
  std::vector<bool> is_point;
};

void writeEdge(Text out, const Constraint& constraint, const Names& names) {
  const geometry::Pose2& pose = constraint.T_from_to;
  const Eigen::Matrix3d& omega = constraint.information;
  const NodeId from = names.ids[constraint.from];
  const NodeId to = names.ids[constraint.to];
  if (names.is_point[constraint.to]) {
    fmt::format_to(out, "EDGE_SE2_XY {} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", from, to,
                   pose.x, pose.y, omega(0, 0), omega(0, 1), omega(1, 1));
    return;
  }
  fmt::format_to(out, "EDGE_SE2 {} {} {:.17g} {:.17g} {:.17g}", from, to, pose.x, pose.y,
                 pose.theta);
  fmt::format_to(out, " {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", omega(0, 0),
                 omega(0, 1), omega(0, 2), omega(1, 1), omega(1, 2), omega(2, 2));
}

}  // namespace

std::string toG2o(const GraphFile& file) {
  const PoseGraph& graph = file.graph;
  const Names names(file);
  fmt::memory_buffer text;
  const Text out(text);
  for (std::size_t node = 0; node < graph.poses.size(); ++node) {
    const geometry::Pose2& pose = graph.poses[node];
    if (names.is_point[node]) {
      fmt::format_to(out, "VERTEX_XY {} {:.17g} {:.17g}\n", names.ids[node], pose.x, pose.y);
    } else {
      fmt::format_to(out, "VERTEX_SE2 {} {:.17g} {:.17g} {:.17g}\n", names.ids[node], pose.x,
                     pose.y, pose.theta);
    }
  }
  for (const NodeId node : graph.held) {
    fmt::format_to(out, "FIX {}\n", names.ids[node]);
  }
  if (graph.held.empty() && !graph.poses.empty()) {
    fmt::format_to(out, "FIX {}\n", names.ids[0]);
  }
  for (const Constraint& constraint : graph.constraints) {
    writeEdge(out, constraint, names);
  }
  return fmt::to_string(text);
}

std::string toG2o(const PoseGraph& graph) { return toG2o(GraphFile{graph, {}}); }

std::string toToro(const GraphFile& file) {
  const PoseGraph& graph = file.graph;
  if (!graph.points.empty()) {
    throw std::invalid_argument("the graph has points, which TORO's format can't express");
  }
  const Names names(file);
  fmt::memory_buffer text;
  const Text out(text);
  for (std::size_t node = 0; node < graph.poses.size(); ++node) {
    const geometry::Pose2& pose = graph.poses[node];
    fmt::format_to(out, "VERTEX2 {} {:.17g} {:.17g} {:.17g}\n", names.ids[node], pose.x, pose.y,
                   pose.theta);
  }
  for (const Constraint& constraint : graph.constraints) {
    const geometry::Pose2& pose = constraint.T_from_to;
    const Eigen::Matrix3d& omega = constraint.information;
    fmt::format_to(out, "EDGE2 {} {} {:.17g} {:.17g} {:.17g}", names.ids[constraint.from],
                   names.ids[constraint.to], pose.x, pose.y, pose.theta);
    fmt::format_to(out, " {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", omega(0, 0),
                   omega(0, 1), omega(1, 1), omega(2, 2), omega(0, 2), omega(1, 2));
  }
  return fmt::to_string(text);
}

std::string toText(const GraphFile& file, const std::filesystem::path& path) {
  const bool is_toro = path.extension() == ".toro" || path.extension() == ".graph";
  return is_toro ? toToro(file) : toG2o(file);
}

}  // namespace omega_slam::graph
