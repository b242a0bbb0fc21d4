#include "omega_slam/graph/graph_file.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::graph {
namespace {

/// The fields of one line; every complaint names file and line.
class Line {
 public:
  Line(const std::string& text, std::string where) : where_(std::move(where)), stream_(text) {
    stream_.imbue(std::locale::classic());
    stream_ >> tag_;
  }

  [[nodiscard]] const std::string& tag() const { return tag_; }
  [[nodiscard]] bool isBlank() const { return tag_.empty() || tag_.front() == '#'; }

  NodeId id() {
    std::int64_t value = -1;
    if (!(stream_ >> value) || value < 0 || value > std::numeric_limits<NodeId>::max()) {
      throw fault("an id is missing or not a whole number from 0 to 4294967295");
    }
    return static_cast<NodeId>(value);
  }

  double number() {
    double value = 0.0;
    if (!(stream_ >> value) || !std::isfinite(value)) {
      throw fault("a field is missing or not a finite number");
    }
    return value;
  }

  geometry::Pose2 pose() {
    const double x = number();
    const double y = number();
    return {x, y, geometry::normalizeAngle(number())};
  }

  void end() {
    std::string rest;
    if (stream_ >> rest) {
      throw fault(fmt::format("there is more than expected: '{}'", rest));
    }
  }

  [[nodiscard]] std::runtime_error fault(const std::string& why) const {
    return std::runtime_error(
        fmt::format("{}: {}{}.", where_, tag_.empty() ? "" : tag_ + ": ", why));
  }

 private:
  std::string where_;
  std::istringstream stream_;
  std::string tag_;
};

Eigen::Matrix3d readInformation(Line& line) {
  Eigen::Matrix3d information;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      information(row, column) = information(column, row) = line.number();
    }
  }
  // Rounding in the file may push an eigenvalue that is zero a little below.
  constexpr double kRounding = 1e-6;
  const Eigen::Vector3d eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  if (!(eigenvalues[0] >= -kRounding * std::abs(eigenvalues[2]))) {
    throw line.fault("the information matrix is not positive semi-definite");
  }
  return information;
}

/// What a file says, before ids become indices.
struct Content {
  std::map<NodeId, geometry::Pose2> poses;
  std::vector<std::pair<Constraint, std::string>> constraints;  ///< with where it stands
  std::vector<std::pair<NodeId, std::string>> fixed;
};

void readLine(Line& line, const std::string& where, Content& content) {
  if (line.tag() == "VERTEX_SE2") {
    const NodeId id = line.id();
    if (!content.poses.emplace(id, line.pose()).second) {
      throw line.fault(fmt::format("node {} was there before", id));
    }
  } else if (line.tag() == "EDGE_SE2") {
    Constraint constraint;
    constraint.from = line.id();
    constraint.to = line.id();
    if (constraint.from == constraint.to) {
      throw line.fault(fmt::format("node {} is tied to itself", constraint.from));
    }
    constraint.T_from_to = line.pose();
    constraint.information = readInformation(line);
    const NodeId low = std::min(constraint.from, constraint.to);
    const NodeId high = std::max(constraint.from, constraint.to);
    constraint.kind = high - low == 1 ? ConstraintKind::kOdometry : ConstraintKind::kLoop;
    content.constraints.emplace_back(constraint, where);
  } else if (line.tag() == "FIX") {
    content.fixed.emplace_back(line.id(), where);
  } else {
    throw line.fault("this tag is unknown here; known are VERTEX_SE2, EDGE_SE2 and FIX");
  }
  line.end();
}

/// A file without vertices: every pose follows from the one before.
void chainPoses(const std::string& name, Content& content) {
  std::map<NodeId, geometry::Pose2> steps;  // from the node before
  NodeId last = 0;
  for (const auto& [constraint, where] : content.constraints) {
    last = std::max({last, constraint.from, constraint.to});
    if (constraint.kind == ConstraintKind::kOdometry) {
      const bool forward = constraint.to > constraint.from;
      steps.emplace(std::max(constraint.from, constraint.to),
                    forward ? constraint.T_from_to : constraint.T_from_to.inverse());
    }
  }
  geometry::Pose2 T_map_node;
  content.poses.emplace(0, T_map_node);
  for (NodeId id = 1; id <= last; ++id) {
    const auto step = steps.find(id);
    if (step == steps.end()) {
      throw std::runtime_error(fmt::format(
          "{}: there are no vertices, and no edge leads from node {} to node {} to make "
          "up for it.",
          name, id - 1, id));
    }
    T_map_node = T_map_node * step->second;
    content.poses.emplace(id, T_map_node);
  }
}

/// Numbers the nodes 0, 1, 2, ... and checks that whatever is spoken of is there.
PoseGraph number(const Content& content) {
  PoseGraph graph;
  std::map<NodeId, NodeId> index;
  for (const auto& [id, pose] : content.poses) {
    index.emplace(id, static_cast<NodeId>(graph.poses.size()));
    graph.poses.push_back(pose);
  }
  const auto find = [&index](NodeId id, const std::string& where) {
    const auto found = index.find(id);
    if (found == index.end()) {
      throw std::runtime_error(fmt::format("{}: node {} is not in the file.", where, id));
    }
    return found->second;
  };
  for (const auto& [constraint, where] : content.constraints) {
    graph.constraints.push_back(constraint);
    graph.constraints.back().from = find(constraint.from, where);
    graph.constraints.back().to = find(constraint.to, where);
  }
  for (const auto& [id, where] : content.fixed) {
    static_cast<void>(find(id, where));
  }
  return graph;
}

}  // namespace

std::string toG2o(const PoseGraph& graph) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (std::size_t id = 0; id < graph.poses.size(); ++id) {
    const geometry::Pose2& pose = graph.poses[id];
    fmt::format_to(out, "VERTEX_SE2 {} {:.17g} {:.17g} {:.17g}\n", id, pose.x, pose.y, pose.theta);
  }
  if (!graph.poses.empty()) {
    fmt::format_to(out, "FIX 0\n");
  }
  for (const Constraint& constraint : graph.constraints) {
    const geometry::Pose2& pose = constraint.T_from_to;
    const Eigen::Matrix3d& omega = constraint.information;
    fmt::format_to(out, "EDGE_SE2 {} {} {:.17g} {:.17g} {:.17g}", constraint.from, constraint.to,
                   pose.x, pose.y, pose.theta);
    fmt::format_to(out, " {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", omega(0, 0),
                   omega(0, 1), omega(0, 2), omega(1, 1), omega(1, 2), omega(2, 2));
  }
  return fmt::to_string(text);
}

PoseGraph fromG2o(std::string_view text, const std::string& name) {
  Content content;
  std::istringstream stream{std::string(text)};
  std::string row;
  for (int number_of_line = 1; std::getline(stream, row); ++number_of_line) {
    const std::string where = fmt::format("{}:{}", name, number_of_line);
    Line line(row, where);
    if (!line.isBlank()) {
      readLine(line, where, content);
    }
  }
  if (content.poses.empty() && !content.constraints.empty()) {
    chainPoses(name, content);
  }
  return number(content);
}

PoseGraph loadGraph(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  // A folder opens like a file, but can't be read.
  if (!file || std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{} could not be read: {}.", path.string(),
                                         file ? "it is a folder"
                                              : "there is no such file, or no "
                                                "permission to read it"));
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return fromG2o(text, path.string());
}

}  // namespace omega_slam::graph
