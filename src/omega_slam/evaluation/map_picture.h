#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::evaluation {

/// What a picture of a map shows. All in the frame of the map.
struct MapPicture {
  grid::OccupancyGrid map;
  geometry::Trajectory estimated_path;  ///< `T_map_base`; may be empty
  geometry::Trajectory true_path;       ///< in the map's frame; may be empty
  std::string caption;                  ///< one short line, ASCII; may be empty
};

/// Draws the map to be looked at: unknown grey, free white, walls dark, paths in colour with marks
/// where the estimated one starts and ends; below it a scale bar, a legend and the caption. Small
/// maps are magnified by a whole number to 1000 pixels or more, large ones reduced to 4000. Where
/// many cells share a pixel a wall outdoes free space and that the unknown. The same input gives
/// the same bytes.
/// @return the bytes of a PNG
/// @throws std::invalid_argument for a map without cells
[[nodiscard]] std::string encodeMapPicture(const MapPicture& picture);

/// Writes it atomically. @return an empty string, or one sentence that names file and cause
[[nodiscard]] std::string writeMapPicture(const std::filesystem::path& path,
                                          const MapPicture& picture);

}  // namespace omega_slam::evaluation
