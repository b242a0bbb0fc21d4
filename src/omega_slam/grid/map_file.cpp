#include "omega_slam/grid/map_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/pgm.h"

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

/// Reads the values of one map.yaml; every complaint names the file and the key.
class MapYaml {
 public:
  explicit MapYaml(const fs::path& path) : path_(path) {
    const std::string text = readFile(path);
    try {
      root_ = YAML::Load(text);
    } catch (const YAML::Exception& error) {
      throw fault(fmt::format("not YAML: {} (line {})", error.msg, error.mark.line + 1));
    }
    if (!root_.IsMap()) {
      throw fault("not a map description: it has no keys");
    }
  }

  template <typename Value>
  Value get(const char* key, const char* expected) const {
    if (!root_[key]) {
      throw fault(fmt::format("key '{}' is missing", key));
    }
    try {
      return root_[key].as<Value>();
    } catch (const YAML::Exception&) {
      throw fault(fmt::format("key '{}' must be {}", key, expected));
    }
  }

  /// map_server takes 0 and 1 as well as true and false.
  [[nodiscard]] bool flag(const char* key) const {
    const auto text = get<std::string>(key, "0 or 1");
    if (text == "0" || text == "1") {
      return text == "1";
    }
    return get<bool>(key, "0 or 1");
  }

  [[nodiscard]] bool has(const char* key) const { return static_cast<bool>(root_[key]); }
  [[nodiscard]] std::runtime_error fault(const std::string& why) const {
    return std::runtime_error(fmt::format("{}: {}.", path_.string(), why));
  }

 private:
  fs::path path_;
  YAML::Node root_;
};

void readPlace(const MapYaml& yaml, GridGeometry& geometry) {
  geometry.resolution = yaml.get<double>("resolution", "a number of metres");
  if (!std::isfinite(geometry.resolution) || geometry.resolution <= 0.0) {
    throw yaml.fault(
        fmt::format("key 'resolution' must be above 0 m, not {}", geometry.resolution));
  }
  const auto origin = yaml.get<std::vector<double>>("origin", "three numbers [x, y, yaw]");
  if (origin.size() != 3 ||
      !std::all_of(origin.begin(), origin.end(), [](double v) { return std::isfinite(v); })) {
    throw yaml.fault("key 'origin' must be three finite numbers [x, y, yaw]");
  }
  if (origin[2] != 0.0) {
    throw yaml.fault(fmt::format("key 'origin' has a yaw of {}; only 0 is supported", origin[2]));
  }
  geometry.origin = {origin[0], origin[1]};
}

void readThresholds(const MapYaml& yaml, MapImage& map) {
  map.negate = yaml.flag("negate");
  map.occupied_threshold = yaml.get<double>("occupied_thresh", "a number");
  map.free_threshold = yaml.get<double>("free_thresh", "a number");
  // Written so that NaN fails too.
  if (!(map.free_threshold >= 0.0 && map.free_threshold < map.occupied_threshold &&
        map.occupied_threshold <= 1.0)) {
    throw yaml.fault(
        fmt::format("the thresholds must be 0 <= free_thresh < occupied_thresh <= 1, not {} and {}",
                    map.free_threshold, map.occupied_threshold));
  }
  const auto mode = yaml.has("mode") ? yaml.get<std::string>("mode", "a word") : "trinary";
  if (mode != "trinary" && mode != "scale" && mode != "raw") {
    throw yaml.fault(fmt::format("key 'mode' must be trinary, scale or raw, not '{}'", mode));
  }
  map.mode =
      mode == "raw" ? MapMode::kRaw : (mode == "scale" ? MapMode::kScale : MapMode::kTrinary);
}

/// PGM by our own reader, which can say what is wrong with a file; the rest by OpenCV, which can't.
GrayImage decode(const std::string& bytes) {
  if (bytes.size() >= 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '2')) {
    return decodePgm(bytes);
  }
  cv::Mat picture;
  if (!bytes.empty()) {
    try {
      picture =
          cv::imdecode(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), cv::IMREAD_GRAYSCALE);
    } catch (const cv::Exception&) {
      picture.release();
    }
  }
  if (picture.empty()) {
    throw std::runtime_error("it is no image, or a damaged one");
  }
  return {picture.cols, picture.rows, {picture.begin<std::uint8_t>(), picture.end<std::uint8_t>()}};
}

GrayImage readImage(const fs::path& path) {
  const std::string bytes = readFile(path);
  try {
    return decode(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}.", path.string(), error.what()));
  }
}

/// Turns upside down: the first row of an image is its top, of a grid its bottom.
std::vector<std::uint8_t> flipped(const GrayImage& image) {
  std::vector<std::uint8_t> result;
  result.reserve(image.pixels.size());
  for (int row = image.height - 1; row >= 0; --row) {
    const auto start = image.pixels.begin() + static_cast<std::ptrdiff_t>(row) * image.width;
    result.insert(result.end(), start, start + image.width);
  }
  return result;
}

std::int8_t cellFromPixel(const MapImage& map, std::uint8_t pixel) {
  if (map.mode == MapMode::kRaw) {
    return pixel <= 100 ? static_cast<std::int8_t>(pixel) : kUnknown;
  }
  const double occupied = (map.negate ? pixel : 255 - pixel) / 255.0;
  if (occupied > map.occupied_threshold) {
    return kOccupied;
  }
  if (occupied < map.free_threshold) {
    return kFree;
  }
  if (map.mode == MapMode::kTrinary) {
    return kUnknown;
  }
  const double span = map.occupied_threshold - map.free_threshold;
  return static_cast<std::int8_t>(99.0 * (occupied - map.free_threshold) / span);
}

std::uint8_t pixelFromCell(std::int8_t cell) {
  constexpr std::uint8_t kFreePixel = 254;
  constexpr std::uint8_t kOccupiedPixel = 0;
  constexpr std::uint8_t kUnknownPixel = 205;
  if (cell >= 65) {
    return kOccupiedPixel;
  }
  return cell >= 0 && cell <= 25 ? kFreePixel : kUnknownPixel;
}

GrayImage toImage(const OccupancyGrid& map) {
  GrayImage image{map.geometry.width, map.geometry.height, {}};
  image.pixels.reserve(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), std::back_inserter(image.pixels),
                 pixelFromCell);
  image.pixels = flipped(image);
  return image;
}

/// The shortest of the two that reads back as the same number.
std::string numberText(double value) {
  const std::string brief = fmt::format("{:.15g}", value);
  return std::strtod(brief.c_str(), nullptr) == value ? brief : fmt::format("{:.17g}", value);
}

std::string describe(const GridGeometry& geometry, const std::string& image_name) {
  YAML::Emitter name;
  name << YAML::DoubleQuoted << image_name;
  return fmt::format(
      "image: {}\nresolution: {}\norigin: [{}, {}, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\n",
      name.c_str(), numberText(geometry.resolution), numberText(geometry.origin.x()),
      numberText(geometry.origin.y()));
}

std::string whyNotSavable(const OccupancyGrid& map) {
  const GridGeometry& geometry = map.geometry;
  if (geometry.width <= 0 || geometry.height <= 0) {
    return "The map is empty: there is nothing to save.";
  }
  if (map.cells.size() != geometry.size()) {
    return fmt::format("The map has {} cells, but {} x {} were announced: it was not saved.",
                       map.cells.size(), geometry.width, geometry.height);
  }
  if (!(geometry.resolution > 0.0) || !std::isfinite(geometry.resolution) ||
      !geometry.origin.allFinite()) {
    return "The map's resolution or origin is not a number: it was not saved.";
  }
  return {};
}

fs::path withEnding(const fs::path& stem, const char* ending) {
  fs::path path = stem;
  path += ending;  // not replace_extension: "map.v2" must keep its "v2"
  return path;
}

}  // namespace

MapImage loadMapImage(const fs::path& path) {
  const MapYaml yaml(path);
  MapImage map;
  readPlace(yaml, map.geometry);
  readThresholds(yaml, map);
  const auto name = yaml.get<std::string>("image", "a file name");
  if (name.empty()) {
    throw yaml.fault("key 'image' names no file");
  }
  const GrayImage image = readImage(path.parent_path() / name);
  map.geometry.width = image.width;
  map.geometry.height = image.height;
  map.pixels = flipped(image);
  return map;
}

OccupancyGrid toOccupancyGrid(const MapImage& image) {
  OccupancyGrid map{image.geometry, {}};
  map.cells.reserve(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), std::back_inserter(map.cells),
                 [&image](std::uint8_t pixel) { return cellFromPixel(image, pixel); });
  return map;
}

SaveResult saveMap(const OccupancyGrid& map, const fs::path& stem) {
  SaveResult result;
  result.message = whyNotSavable(map);
  if (!result.message.empty()) {
    return result;
  }
  const fs::path image = withEnding(stem, ".pgm");
  const fs::path yaml = withEnding(stem, ".yaml");
  const std::string comment = fmt::format("{} m/pix", numberText(map.geometry.resolution));
  result.message = writeFileAtomically(image, encodePgm(toImage(map), comment));
  if (!result.message.empty()) {
    return result;
  }
  result.paths.push_back(image);
  result.message = writeFileAtomically(yaml, describe(map.geometry, image.filename().string()));
  if (!result.message.empty()) {
    return result;
  }
  result.paths.push_back(yaml);
  result.success = true;
  result.message = fmt::format("The map ({} x {} cells) is saved as {} and {}.", map.geometry.width,
                               map.geometry.height, image.string(), yaml.string());
  return result;
}

}  // namespace omega_slam::grid
