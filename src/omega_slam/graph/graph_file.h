#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// A graph, and what its nodes are called in the file that it came from.
struct GraphFile {
  PoseGraph graph;
  std::vector<NodeId> ids;  ///< by index; empty where these are the indices themselves
};

/// The graph as g2o writes it: `VERTEX_SE2 id x y theta`, `VERTEX_XY id x y` for points, `FIX id`
/// and `EDGE_SE2 from to x y theta I11 I12 I13 I22 I23 I33`, or to a point
/// `EDGE_SE2_XY from to x y I11 I12 I22` (m, rad; upper triangle of the information matrix, row by
/// row). Every number in full: reading gives the same bits, and equal graphs give equal text. Kinds
/// and confidences of constraints have no place in the format and are lost.
[[nodiscard]] std::string toG2o(const GraphFile& file);
[[nodiscard]] std::string toG2o(const PoseGraph& graph);

/// The same as TORO writes it: `VERTEX2 id x y theta` and
/// `EDGE2 from to x y theta I11 I12 I22 I33 I13 I23`. Which nodes are held has no place in it.
/// @throws std::invalid_argument if the graph has points, for which TORO has no tag
[[nodiscard]] std::string toToro(const GraphFile& file);

/// Reads either: the tags tell. Comments start with #.
///
/// Ids may have gaps; nodes are numbered anew in the order of their ids. Nodes of which the file
/// has edges only get their first guess from these (FirstGuess::kOdometry), from the lowest id at
/// the origin on. An edge between a pose and the next one, in the order of ids, becomes a
/// constraint of kind odometry, any other one a loop: the formats do not say.
///
/// @param name how messages call the text, such as a path
/// @throws std::runtime_error "name:line: why" for a line that is malformed, a number that is not
/// finite, an information matrix that is not positive semi-definite, an id that is double or
/// unknown or of a node of the other kind, a tag that is none of these; "name: why" for edges alone
/// that lead beyond all numbers. What it quotes is short and printable.
[[nodiscard]] GraphFile readGraph(std::string_view text, const std::string& name);

/// Reads a file. @throws std::runtime_error as above, or if the file can't be read
[[nodiscard]] GraphFile loadGraph(const std::filesystem::path& path);

/// The format of a path: `.toro` and `.graph` are TORO's, all others g2o's.
[[nodiscard]] std::string toText(const GraphFile& file, const std::filesystem::path& path);

}  // namespace omega_slam::graph
