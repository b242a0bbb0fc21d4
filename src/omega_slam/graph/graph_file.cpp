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
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/first_guess.h"

namespace omega_slam::graph {
namespace {

/// Text of a file as it can be shown to a person, whatever it is.
std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = text.substr(0, kLongest);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > kLongest ? shown + "..." : shown;
}

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
    if (!(stream_ >> value) || !isFieldEnd() || value < 0 ||
        value > std::numeric_limits<NodeId>::max()) {
      throw fault("an id is missing or not a whole number from 0 to 4294967295");
    }
    return static_cast<NodeId>(value);
  }

  double number() {
    double value = 0.0;
    if (!(stream_ >> value) || !isFieldEnd() || !std::isfinite(value)) {
      throw fault("a field is missing or not a finite number");
    }
    return value;
  }

  geometry::Pose2 pose() {
    const double x = number();
    const double y = number();
    return {x, y, geometry::normalizeAngle(number())};
  }

  geometry::Pose2 point() {
    const double x = number();
    return {x, number(), 0.0};
  }

  [[nodiscard]] bool isAtEnd() { return (stream_ >> std::ws).eof(); }

  void end() {
    std::string rest;
    if (stream_ >> rest) {
      throw fault(fmt::format("there is more than expected: '{}'", shown(rest)));
    }
  }

  [[nodiscard]] std::runtime_error fault(const std::string& why) const {
    return std::runtime_error(
        fmt::format("{}: {}{}.", where_, tag_.empty() ? "" : shown(tag_) + ": ", why));
  }

 private:
  /// Whether a number ends where its field does: "2.5" is not an id with ".5" behind it.
  [[nodiscard]] bool isFieldEnd() {
    return stream_.eof() || std::isspace(static_cast<char>(stream_.peek()), stream_.getloc());
  }

  std::string where_;
  std::istringstream stream_;
  std::string tag_;
};

/// Places of the upper triangle of an information matrix, in the order of a format.
using Elements = std::vector<std::pair<int, int>>;

Eigen::Matrix3d readInformation(Line& line, const Elements& elements) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const auto& [row, column] : elements) {
    information(row, column) = information(column, row) = line.number();
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
  std::set<NodeId> points;
};

void readNode(Line& line, Content& content, bool is_point) {
  const NodeId id = line.id();
  if (!content.poses.emplace(id, is_point ? line.point() : line.pose()).second) {
    throw line.fault(fmt::format("node {} was there before", id));
  }
  if (is_point) {
    content.points.insert(id);
  }
}

Constraint readTie(Line& line) {
  Constraint constraint;
  constraint.from = line.id();
  constraint.to = line.id();
  if (constraint.from == constraint.to) {
    throw line.fault(fmt::format("node {} is tied to itself", constraint.from));
  }
  constraint.kind = ConstraintKind::kLoop;
  return constraint;
}

void readEdge(Line& line, const std::string& where, Content& content, const Elements& elements) {
  Constraint constraint = readTie(line);
  constraint.T_from_to = line.pose();
  constraint.information = readInformation(line, elements);
  content.constraints.emplace_back(constraint, where);
}

void readSight(Line& line, const std::string& where, Content& content) {
  Constraint constraint = readTie(line);
  constraint.kind = ConstraintKind::kLandmark;
  constraint.T_from_to = line.point();
  constraint.information = readInformation(line, {{0, 0}, {0, 1}, {1, 1}});
  content.constraints.emplace_back(constraint, where);
}

void readFixed(Line& line, const std::string& where, Content& content) {
  do {
    content.fixed.emplace_back(line.id(), where);
  } while (!line.isAtEnd());
}

constexpr const char* kTags =
    "VERTEX_SE2, VERTEX_XY, EDGE_SE2, EDGE_SE2_XY, FIX, VERTEX2 and EDGE2";

void readLine(Line& line, const std::string& where, Content& content) {
  const std::string& tag = line.tag();
  if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
    readNode(line, content, false);
  } else if (tag == "VERTEX_XY") {
    readNode(line, content, true);
  } else if (tag == "EDGE_SE2") {
    readEdge(line, where, content, {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}});
  } else if (tag == "EDGE2") {
    readEdge(line, where, content, {{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}});
  } else if (tag == "EDGE_SE2_XY") {
    readSight(line, where, content);
  } else if (tag == "FIX") {
    readFixed(line, where, content);
  } else {
    throw line.fault(fmt::format("this tag is unknown here; known are {}", kTags));
  }
  line.end();
}

/// A file without vertices: its edges say which nodes there are.
void nameNodes(Content& content) {
  for (const auto& [constraint, where] : content.constraints) {
    content.poses.emplace(constraint.from, geometry::Pose2{});
    content.poses.emplace(constraint.to, geometry::Pose2{});
    if (constraint.kind == ConstraintKind::kLandmark) {
      content.points.insert(constraint.to);
    }
  }
}

/// Points are seen, by EDGE_SE2_XY, and nothing else is.
void requireKinds(const Constraint& constraint, const std::string& where,
                  const std::set<NodeId>& points) {
  const bool is_point = points.count(constraint.to) > 0;
  const bool is_sight = constraint.kind == ConstraintKind::kLandmark;
  if (points.count(constraint.from) > 0 || (is_point && !is_sight)) {
    throw std::runtime_error(
        fmt::format("{}: a point can only be the second node of an EDGE_SE2_XY.", where));
  }
  if (is_sight && !is_point) {
    throw std::runtime_error(
        fmt::format("{}: node {} is a pose, and was to be a point.", where, constraint.to));
  }
}

/// An edge between a pose and the next one is odometry: the formats do not say.
void tellOdometry(PoseGraph& graph) {
  std::vector<NodeId> rank(graph.poses.size(), 1);  // among the poses, without the points
  for (const NodeId point : graph.points) {
    rank[point] = 0;
  }
  std::partial_sum(rank.begin(), rank.end(), rank.begin());
  for (Constraint& constraint : graph.constraints) {
    const auto [low, high] = std::minmax(rank[constraint.from], rank[constraint.to]);
    if (constraint.kind == ConstraintKind::kLoop && high - low == 1) {
      constraint.kind = ConstraintKind::kOdometry;
    }
  }
}

/// Numbers the nodes 0, 1, 2, ... and checks that whatever is spoken of is there.
GraphFile number(const Content& content) {
  GraphFile file;
  std::map<NodeId, NodeId> index;
  for (const auto& [id, pose] : content.poses) {
    index.emplace(id, static_cast<NodeId>(file.ids.size()));
    file.ids.push_back(id);
    file.graph.poses.push_back(pose);
  }
  const auto find = [&index](NodeId id, const std::string& where) {
    const auto found = index.find(id);
    if (found == index.end()) {
      throw std::runtime_error(fmt::format("{}: node {} is not in the file.", where, id));
    }
    return found->second;
  };
  for (const auto& [constraint, where] : content.constraints) {
    file.graph.constraints.push_back(constraint);
    file.graph.constraints.back().from = find(constraint.from, where);
    file.graph.constraints.back().to = find(constraint.to, where);
    requireKinds(constraint, where, content.points);
  }
  std::set<NodeId> held;
  for (const auto& [id, where] : content.fixed) {
    const NodeId node = find(id, where);
    if (held.insert(node).second) {
      file.graph.held.push_back(node);
    }
  }
  for (const NodeId point : content.points) {
    file.graph.points.push_back(index.at(point));
  }
  tellOdometry(file.graph);
  return file;
}

/// First guesses of nodes of which a file has edges only.
void guessFromEdges(GraphFile& file, const std::string& name) {
  PoseGraph& graph = file.graph;
  applyGuess(graph, FirstGuess::kOdometry);
  const auto lost = std::find_if_not(graph.poses.begin(), graph.poses.end(),
                                     [](const geometry::Pose2& pose) { return pose.isFinite(); });
  if (lost != graph.poses.end()) {
    const auto node = static_cast<std::size_t>(lost - graph.poses.begin());
    throw std::runtime_error(
        fmt::format("{}: the edges that lead to node {} are too long.", name, file.ids[node]));
  }
}

}  // namespace

GraphFile readGraph(std::string_view text, const std::string& name) {
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
  const bool has_edges_only = content.poses.empty();
  if (has_edges_only) {
    nameNodes(content);
  }
  GraphFile file = number(content);
  if (has_edges_only) {
    guessFromEdges(file, name);
  }
  return file;
}

GraphFile loadGraph(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  // A folder opens like a file, but can't be read.
  if (!file || std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{} could not be read: {}.", path.string(),
                                         file ? "it is a folder"
                                              : "there is no such file, or no "
                                                "permission to read it"));
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return readGraph(text, path.string());
}

}  // namespace omega_slam::graph
