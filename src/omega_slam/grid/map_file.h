#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::grid {

/// A map_server map as it lies on the disk: grey values and how to read them.
/// `pixels` is row-major with row 0 at the bottom (smallest y), unlike in the image file.
struct MapImage {
  GridGeometry geometry;
  std::vector<std::uint8_t> pixels;
  bool negate{false};  ///< true: white is occupied
  double occupied_threshold{
      0.65};  ///< above: occupied; probability is (255 - pixel) / 255, or pixel / 255 if negated
  double free_threshold{0.196};  ///< below: free
};

/// Reads `map.yaml` and the image that it names (PGM, or whatever OpenCV reads).
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] MapImage loadMapImage(const std::filesystem::path& yaml);

/// The trinary reading of map_server: 0 free, 100 occupied, -1 between the thresholds.
[[nodiscard]] OccupancyGrid toOccupancyGrid(const MapImage& image);

/// What became of a save; truthful.
struct SaveResult {
  bool success{false};
  std::string message;                       ///< one sentence
  std::vector<std::filesystem::path> paths;  ///< files that now exist
};

/// Writes `<stem>.pgm` and `<stem>.yaml` as map_server reads them (free 254, occupied 0, unknown
/// 205), each to a temporary name, synced, then renamed; missing folders are made. Never throws for
/// what the disk does.
[[nodiscard]] SaveResult saveMap(const OccupancyGrid& map, const std::filesystem::path& stem);

}  // namespace omega_slam::grid
