#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::grid {

/// How grey values stand for cells, as in map_server.
///
/// Let g be the grey of a pixel, 255 - g if the image is negated, and b = (255 - g) / 255 how black
/// that is. With the two thresholds, occupied and free:
///
///   mode     read as                                               written as
///   trinary  100 if b > occupied, 0 if b < free, else -1           254 (cell 0..25), 0 (65..100),
///                                                                  205 (all others)
///   scale    100 if b > occupied, 0 if b < free, else              the g that is read as the cell;
///            1 + 98 (b - free) / (occupied - free), cut off,       -1: transparent
///            or -1 if the pixel is transparent
///   raw      g if that is 0..100, else -1                          the cell; -1: 255
enum class MapMode : std::uint8_t { kTrinary = 0, kScale = 1, kRaw = 2 };

/// "trinary", "scale", "raw".
[[nodiscard]] std::string toString(MapMode mode);
[[nodiscard]] std::optional<MapMode> mapModeFromName(const std::string& name);

/// A map_server map as it lies on the disk: grey values and how to read them.
/// `pixels` is row-major with row 0 at the bottom (smallest y), unlike in the image file.
struct MapImage {
  GridGeometry geometry;
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint8_t> opacity;  ///< of each pixel, 0: transparent; empty: all are opaque
  bool negate{false};                 ///< true: white is occupied
  double occupied_threshold{0.65};    ///< in (free_threshold, 1]
  double free_threshold{0.196};       ///< in [0, occupied_threshold)
  MapMode mode{MapMode::kTrinary};
};

/// The cells that an image stands for: -1, or 0 (free) .. 100 (occupied).
[[nodiscard]] OccupancyGrid toOccupancyGrid(const MapImage& image);

/// The image that is read as the same cells: all of them with kScale and kRaw, what is left of them
/// with kTrinary. It has an opacity only with kScale, and where cells are unknown.
[[nodiscard]] MapImage toMapImage(const OccupancyGrid& map, MapMode mode);

}  // namespace omega_slam::grid
