#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::grid {

/// A straight piece of what bounds a room, from one end [m] to the other, in the map's frame.
struct Pane {
  Eigen::Vector2d from{0.0, 0.0};
  Eigen::Vector2d to{0.0, 0.0};
};

/// What a robot has most likely bumped into where the map shows nothing: a pane of glass that fills
/// a gap in a wall. It goes straight through the place that was touched, ends at an obstacle on
/// either side, and behind both ends the wall runs on in line with it; so nothing is found across a
/// corridor, whose walls do not. Of several that do, it is the shortest.
/// @param touched [m] in the map; within a hand's breadth of an obstacle that was touched instead
/// @param normal [m] any length but 0: from the robot to that place, as well as a bumper knows it;
/// the pane runs across it, give or take 29 degrees
/// @return none where there is no such gap, and for what is not finite
[[nodiscard]] std::optional<Pane> findPane(const OccupancyGrid& map, const Eigen::Vector2d& touched,
                                           const Eigen::Vector2d& normal);

/// Points [m] in the map, no cell apart, all along the panes that a round robot touches.
/// @param contacts [m] in the base frame: where bumpers are pressed
/// @param T_map_base where the robot is; @param radius [m] of the robot: no point lies in it
[[nodiscard]] std::vector<Eigen::Vector2d> paneMarks(const OccupancyGrid& map,
                                                     const std::vector<Eigen::Vector2d>& contacts,
                                                     const geometry::Pose2& T_map_base,
                                                     double radius);

}  // namespace omega_slam::grid
