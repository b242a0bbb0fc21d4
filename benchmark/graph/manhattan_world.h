#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::experiments {

struct ManhattanConfig {
  std::size_t poses{1000};
  std::uint64_t seed{1};
  double visits{2.0};                  ///< of each crossing, in the mean
  int returns_a_loop{1};               ///< every how many returns to a crossing it is recognised
  double translation_deviation{0.02};  ///< [m] standard deviation of x and y of a measurement
  double rotation_deviation{0.01};     ///< [rad]
};

/// A drive through a square town of streets one metre apart, whose area grows with the drive: at
/// any size each crossing is visited as often, and poses have as many loops. From crossing to
/// crossing the robot measures its step; back at a crossing that it recognises, it measures its
/// pose seen from the last visit.
struct ManhattanWorld {
  std::vector<geometry::Pose2> truth;
  graph::PoseGraph graph;  ///< poses as the odometry has them
};

[[nodiscard]] ManhattanWorld driveManhattan(const ManhattanConfig& config);

}  // namespace omega_slam::experiments
