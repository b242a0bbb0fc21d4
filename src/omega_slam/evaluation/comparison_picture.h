#pragma once

#include <filesystem>
#include <string>

#include "omega_slam/evaluation/resemblance.h"

namespace omega_slam::evaluation {

/// What a picture of two maps on each other shows.
struct ComparisonPicture {
  grid::OccupancyGrid built;
  grid::OccupancyGrid truth;
  geometry::Pose2 T_truth_map;
  MapComparison comparison;  ///< of these two, at this placement
  std::string caption;       ///< one short line, ASCII; may be empty
};

/// Draws the differences in the true map's frame, whose area is that of both maps: walls that are
/// right dark, wrong walls red, walls that were missed blue, open cells that are wrong orange,
/// those unseen or built as walls pale blue. Where verdicts share a pixel the graver one is drawn.
/// @return the bytes of a PNG
/// @throws std::invalid_argument for maps without cells, of other sizes than the comparison, or so
/// far apart that no picture shows both
[[nodiscard]] std::string encodeComparisonPicture(const ComparisonPicture& picture);

/// Writes it atomically. @return an empty string, or one sentence that names file and cause
[[nodiscard]] std::string writeComparisonPicture(const std::filesystem::path& path,
                                                 const ComparisonPicture& picture);

}  // namespace omega_slam::evaluation
