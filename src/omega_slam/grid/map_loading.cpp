// What map_file.h declares for reading. Apart from the rest, so that programs that only write maps
// need not load all of OpenCV's image formats.
#include <fmt/format.h>

#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_description.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/grid/pgm.h"
#include "omega_slam/grid/picture.h"

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

/// PGM by our own reader, which can say what is wrong with a file; the rest by OpenCV, which can't.
GrayImage decode(const std::string& bytes) {
  const bool is_pgm = bytes.size() >= 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '2');
  return is_pgm ? decodePgm(bytes) : decodePicture(bytes);
}

GrayImage readImage(const fs::path& path) {
  const std::string bytes = readFile(path);
  try {
    return decode(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}.", path.string(), error.what()));
  }
}

}  // namespace

MapImage loadMapImage(const fs::path& path) {
  const MapDescription description = readDescription(path);
  MapImage map = description.map;
  const GrayImage image = readImage(path.parent_path() / description.image_name);
  map.geometry.width = image.width;
  map.geometry.height = image.height;
  map.pixels = upsideDown(image.pixels, image.width);
  map.opacity = upsideDown(image.opacity, image.width);
  return map;
}

}  // namespace omega_slam::grid
