#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::evaluation {

/// One panel of a picture of graphs.
struct GraphPanel {
  graph::PoseGraph graph;
  std::vector<double> weights;  ///< [0, 1] of the constraints; empty: all 1
  std::string caption;          ///< one short line, ASCII
};

/// Draws graphs side by side, each fitted into a square: constraints of odometry and matches blue,
/// loops red, loops of a weight below one half orange, points green. The same input gives the same
/// bytes. @return the bytes of a PNG
[[nodiscard]] std::string encodeGraphPicture(const std::vector<GraphPanel>& panels);

/// Writes it atomically. @return an empty string, or one sentence that names file and cause
[[nodiscard]] std::string writeGraphPicture(const std::filesystem::path& path,
                                            const std::vector<GraphPanel>& panels);

}  // namespace omega_slam::evaluation
