#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::grid {

/// How map_server turns grey values into cells.
enum class MapMode : std::uint8_t {
  kTrinary = 0,  ///< free, occupied or unknown, by the thresholds
  kScale = 1,    ///< as above, but between the thresholds 0..99 in proportion
  kRaw = 2       ///< a grey value of 0..100 is the cell's value, anything else is unknown
};

/// A map_server map as it lies on the disk: grey values and how to read them.
/// `pixels` is row-major with row 0 at the bottom (smallest y), unlike in the image file.
struct MapImage {
  GridGeometry geometry;
  std::vector<std::uint8_t> pixels;
  bool negate{false};  ///< true: white is occupied
  double occupied_threshold{
      0.65};  ///< above: occupied; probability is (255 - pixel) / 255, or pixel / 255 if negated
  double free_threshold{0.196};  ///< below: free
  MapMode mode{MapMode::kTrinary};
};

/// Reads `map.yaml` and the image that it names (PGM, or whatever OpenCV reads). As for map_server,
/// every key but `mode` must be there; keys that we do not know are left alone. Images are axis
/// parallel here: a yaw of the origin other than 0 is refused.
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] MapImage loadMapImage(const std::filesystem::path& yaml);

/// The cells that the image stands for by its mode: 0 free, 100 occupied, -1 unknown.
[[nodiscard]] OccupancyGrid toOccupancyGrid(const MapImage& image);

/// What became of a save; truthful.
struct SaveResult {
  bool success{false};
  std::string message;                       ///< one sentence
  std::vector<std::filesystem::path> paths;  ///< files that this save has written
};

/// Writes `<stem>.pgm` and `<stem>.yaml` as map_server reads them (free 254, occupied 0, unknown
/// 205), each to a temporary name, synced, then renamed; missing folders are made. Cells of 25 and
/// less are written as free, of 65 and more as occupied, as map_saver does. The image comes first:
/// a YAML file never names an image that is not there. Never throws for what the disk does.
[[nodiscard]] SaveResult saveMap(const OccupancyGrid& map, const std::filesystem::path& stem);

}  // namespace omega_slam::grid
