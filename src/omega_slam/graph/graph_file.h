#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// The graph as g2o writes it: `VERTEX_SE2 id x y theta`, `FIX 0` and
/// `EDGE_SE2 from to x y theta I11 I12 I13 I22 I23 I33` (m, rad; upper triangle of the information
/// matrix, row by row). Every number in full: reading gives the same bits, and equal graphs give
/// equal text. Kinds and confidences of constraints have no place in the format and are lost.
[[nodiscard]] std::string toG2o(const PoseGraph& graph);

/// Reads such text.
///
/// Ids may have gaps; nodes are then numbered anew in the order of their ids. A file that has edges
/// only gets its first guess from the chain of edges between consecutive ids, starting at the
/// origin. An edge between consecutive ids becomes a constraint of kind odometry, any other one a
/// loop: the format does not say. FIX is checked and otherwise ignored, as the solver holds the
/// first node.
///
/// @param name how messages call the text, such as a path
/// @throws std::runtime_error "name:line: why" for a line that is malformed, a number that is not
/// finite, an information matrix that is not positive semi-definite, an id that is double or
/// unknown, a tag that is none of these three (comments start with #)
[[nodiscard]] PoseGraph fromG2o(std::string_view text, const std::string& name);

/// Reads a g2o file. @throws std::runtime_error as above, or if the file can't be read
[[nodiscard]] PoseGraph loadGraph(const std::filesystem::path& path);

}  // namespace omega_slam::graph
