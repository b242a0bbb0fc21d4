#include "omega_slam/grid/map_image.h"

#include <algorithm>
#include <array>

namespace omega_slam::grid {
namespace {

constexpr const char* kModeNames[] = {"trinary", "scale", "raw"};
constexpr int kGreys = 256;

std::int8_t cellFromPixel(const MapImage& map, std::uint8_t pixel, bool is_opaque) {
  const auto grey = static_cast<std::uint8_t>(map.negate ? 255 - pixel : pixel);
  if (map.mode == MapMode::kRaw) {
    return grey <= 100 ? static_cast<std::int8_t>(grey) : kUnknown;
  }
  const double black = (255 - grey) / 255.0;
  if (black > map.occupied_threshold) {
    return kOccupied;
  }
  if (black < map.free_threshold) {
    return kFree;
  }
  if (map.mode == MapMode::kTrinary || !is_opaque) {
    return kUnknown;
  }
  const double span = map.occupied_threshold - map.free_threshold;
  return static_cast<std::int8_t>(1.0 + 98.0 * (black - map.free_threshold) / span);
}

std::uint8_t trinaryPixel(std::int8_t cell) {
  constexpr std::uint8_t kFreePixel = 254;
  constexpr std::uint8_t kOccupiedPixel = 0;
  constexpr std::uint8_t kUnknownPixel = 205;
  if (cell >= 65 && cell <= 100) {
    return kOccupiedPixel;
  }
  return cell >= 0 && cell <= 25 ? kFreePixel : kUnknownPixel;
}

/// So that of 256 greys white alone is free, black alone is occupied, and the 254 between them lead
/// to all of 1..99.
void spreadThresholds(MapImage& image) {
  image.free_threshold = 0.5 / 255.0;
  image.occupied_threshold = 254.0 / 255.0;
}

/// For each cell 0..100 a grey that is read as it.
std::array<std::uint8_t, 101> scalePixels(const MapImage& image) {
  std::array<std::uint8_t, 101> pixels{};
  for (int grey = 0; grey < kGreys; ++grey) {
    const auto pixel = static_cast<std::uint8_t>(grey);
    pixels[static_cast<std::size_t>(cellFromPixel(image, pixel, true))] = pixel;
  }
  return pixels;
}

void drawScale(const OccupancyGrid& map, MapImage& image) {
  constexpr std::uint8_t kBetween = 128;  // neither free nor occupied, so that opacity counts
  spreadThresholds(image);
  const std::array<std::uint8_t, 101> pixels = scalePixels(image);
  const auto is_known = [](std::int8_t cell) { return cell >= 0 && cell <= 100; };
  for (const std::int8_t cell : map.cells) {
    image.pixels.push_back(is_known(cell) ? pixels[static_cast<std::size_t>(cell)] : kBetween);
  }
  if (!std::all_of(map.cells.begin(), map.cells.end(), is_known)) {
    for (const std::int8_t cell : map.cells) {
      image.opacity.push_back(is_known(cell) ? 255 : 0);
    }
  }
}

}  // namespace

std::string toString(MapMode mode) { return kModeNames[static_cast<std::size_t>(mode)]; }

std::optional<MapMode> mapModeFromName(const std::string& name) {
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale, MapMode::kRaw}) {
    if (toString(mode) == name) {
      return mode;
    }
  }
  return std::nullopt;
}

OccupancyGrid toOccupancyGrid(const MapImage& image) {
  OccupancyGrid map{image.geometry, {}};
  map.cells.reserve(image.pixels.size());
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const bool is_opaque = image.opacity.empty() || image.opacity[k] > 0;
    map.cells.push_back(cellFromPixel(image, image.pixels[k], is_opaque));
  }
  return map;
}

MapImage toMapImage(const OccupancyGrid& map, MapMode mode) {
  MapImage image;
  image.geometry = map.geometry;
  image.mode = mode;
  image.pixels.reserve(map.cells.size());
  if (mode == MapMode::kScale) {
    drawScale(map, image);
    return image;
  }
  std::transform(map.cells.begin(), map.cells.end(), std::back_inserter(image.pixels),
                 [mode](std::int8_t cell) {
                   if (mode == MapMode::kTrinary) {
                     return trinaryPixel(cell);
                   }
                   return cell >= 0 && cell <= 100 ? static_cast<std::uint8_t>(cell)
                                                   : std::uint8_t{255};
                 });
  return image;
}

}  // namespace omega_slam::grid
