#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "navigation/course.h"

namespace omega_slam::experiments {

/// One goal among people, and what became of it.
struct GoalResult {
  std::string wanted;   ///< "reached", or why the map has no way there
  std::string outcome;  ///< "reached", or the reason for giving up
  bool right{false};    ///< the outcome is the wanted one
  double seconds{0.0};
  double planned{0.0};         ///< [m] of the first plan
  double driven{0.0};          ///< [m]
  int collisions{0};           ///< times that the robot has driven into something
  double nearest_person{0.0};  ///< [m] between robot and person, at the least
};

struct GoalTrial {
  std::size_t goals{50};
  std::size_t people{3};
  double anywhere{
      0.2};  ///< share of the goals that may be anywhere, in walls and beyond the map too
  std::uint64_t seed{1};
};

/// Sends a simulated robot, which knows the map and where it is, to goal after goal. What it does
/// not know is where people walk. A goal that takes longer than ten minutes is a failure.
[[nodiscard]] std::vector<GoalResult> driveToGoals(const Course& course, const GoalTrial& trial);

}  // namespace omega_slam::experiments
