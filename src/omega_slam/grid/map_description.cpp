#include "omega_slam/grid/map_description.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKeys[] = {"image",           "resolution",  "origin", "negate",
                                 "occupied_thresh", "free_thresh", "mode"};

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
    checkKeys();
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
  void checkKeys() const {
    for (const auto& entry : root_) {
      const auto key = entry.first.IsScalar() ? entry.first.as<std::string>() : std::string();
      if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys)) {
        throw fault(fmt::format("key '{}' is not known; there are {}", key,
                                fmt::join(std::begin(kKeys), std::end(kKeys), ", ")));
      }
    }
  }

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

void readMeaning(const MapYaml& yaml, MapImage& map) {
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
  if (yaml.has("mode")) {
    const auto name = yaml.get<std::string>("mode", "a word");
    const auto mode = mapModeFromName(name);
    if (!mode) {
      throw yaml.fault(fmt::format("key 'mode' must be trinary, scale or raw, not '{}'", name));
    }
    map.mode = *mode;
  }
}

}  // namespace

MapDescription readDescription(const fs::path& path) {
  const MapYaml yaml(path);
  MapDescription description;
  readPlace(yaml, description.map.geometry);
  readMeaning(yaml, description.map);
  description.image_name = yaml.get<std::string>("image", "a file name");
  if (description.image_name.empty()) {
    throw yaml.fault("key 'image' names no file");
  }
  return description;
}

std::string toYaml(const MapDescription& description) {
  const MapImage& map = description.map;
  YAML::Emitter name;
  name << YAML::DoubleQuoted << description.image_name;
  std::string text = fmt::format(
      "image: {}\nresolution: {}\norigin: [{}, {}, 0]\nnegate: {:d}\noccupied_thresh: {}\n"
      "free_thresh: {}\n",
      name.c_str(), numberText(map.geometry.resolution), numberText(map.geometry.origin.x()),
      numberText(map.geometry.origin.y()), map.negate, numberText(map.occupied_threshold),
      numberText(map.free_threshold));
  if (map.mode != MapMode::kTrinary) {
    text += fmt::format("mode: {}\n", toString(map.mode));
  }
  return text;
}

std::string numberText(double value) {
  const std::string brief = fmt::format("{:.15g}", value);
  return std::strtod(brief.c_str(), nullptr) == value ? brief : fmt::format("{:.17g}", value);
}

}  // namespace omega_slam::grid
