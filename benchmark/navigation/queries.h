#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "navigation/course.h"

namespace omega_slam::experiments {

/// One question for a way, and the answer beside that of the oracle: the shortest way over the
/// grid, whatever the room.
struct QueryResult {
  bool has_way{false};  ///< says the oracle
  bool found{false};
  double length{0.0};        ///< [m]
  double shortest{0.0};      ///< [m] of the oracle's way
  double milliseconds{0.0};  ///< of processor time, for the plan
  double least_clearance{
      0.0};  ///< [m] from the path to the nearest square that is occupied or unknown
};

/// Asks for ways between random places where the robot can stand.
/// @param planner one of navigation::plannerNames()
[[nodiscard]] std::vector<QueryResult> askForWays(const Course& course, const std::string& planner,
                                                  std::size_t queries, std::uint64_t seed);

/// From a path to the nearest square of a map that is occupied or unknown, or beyond its edge, if
/// nearer than `reach` [m]: by looking at every square about every leg.
[[nodiscard]] double leastClearance(const grid::OccupancyGrid& map, const navigation::Path& path,
                                    double reach);

}  // namespace omega_slam::experiments
