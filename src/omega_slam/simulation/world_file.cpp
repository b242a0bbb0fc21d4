#include "omega_slam/simulation/world_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/map_file.h"

namespace omega_slam::simulation {
namespace {

constexpr std::array<const char*, 4> kKeys{"map", "description", "start", "route"};

/// One open world file; knows how to complain about it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path) {
    try {
      root_ = YAML::LoadFile(path.string());
    } catch (const YAML::BadFile&) {
      fail("cannot be opened");
    } catch (const YAML::Exception& error) {
      fail(fmt::format("is not valid YAML: {}", error.what()));
    }
    if (!root_.IsMap()) {
      fail("does not hold keys and values");
    }
    for (const auto& entry : root_) {
      if (!entry.first.IsScalar()) {
        fail("has a key that is not a word");
      }
      const std::string& key = entry.first.Scalar();
      if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
        fail(fmt::format("has the unknown key '{}'; known are {}", key, fmt::join(kKeys, ", ")));
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("World file '{}' {}.", path_.string(), what));
  }

  [[nodiscard]] bool has(const std::string& key) const { return root_[key].IsDefined(); }

  [[nodiscard]] std::string text(const std::string& key) const {
    const YAML::Node node = required(key);
    if (!node.IsScalar() || node.Scalar().empty()) {
      fail(fmt::format("needs a text for the key '{}'", key));
    }
    return node.Scalar();
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const {
    return numbers(required(key), key, count);
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> points(const std::string& key) const {
    const YAML::Node node = required(key);
    if (!node.IsSequence()) {
      fail(fmt::format("needs a list of points [x, y] for the key '{}'", key));
    }
    std::vector<Eigen::Vector2d> result;
    for (std::size_t i = 0; i < node.size(); ++i) {
      const std::vector<double> xy = numbers(node[i], fmt::format("{}[{}]", key, i), 2);
      result.emplace_back(xy[0], xy[1]);
    }
    return result;
  }

 private:
  [[nodiscard]] YAML::Node required(const std::string& key) const {
    if (!has(key)) {
      fail(fmt::format("lacks the key '{}'", key));
    }
    return root_[key];
  }

  [[nodiscard]] std::vector<double> numbers(const YAML::Node& node, const std::string& key,
                                            std::size_t count) const {
    std::vector<double> result;
    if (node.IsSequence()) {
      for (const YAML::Node& element : node) {
        if (const auto number = finiteNumber(element)) {
          result.push_back(*number);
        }
      }
    }
    if (result.size() != count || node.size() != count) {
      fail(fmt::format("needs {} finite numbers in a list for the key '{}'", count, key));
    }
    return result;
  }

  [[nodiscard]] static std::optional<double> finiteNumber(const YAML::Node& node) {
    double value = 0.0;
    const bool quoted = node.Tag() == "!";
    if (!node.IsScalar() || quoted || !YAML::convert<double>::decode(node, value) ||
        !std::isfinite(value)) {
      return std::nullopt;
    }
    return value;
  }

  std::filesystem::path path_;
  YAML::Node root_;
};

}  // namespace

WorldFile readWorldFile(const std::filesystem::path& path) {
  const Reader reader(path);
  WorldFile file;
  file.map = path.parent_path() / reader.text("map");
  file.description = reader.text("description");
  const std::vector<double> start = reader.numbers("start", 3);
  file.start = {start[0], start[1], geometry::normalizeAngle(start[2])};
  if (reader.has("route")) {
    file.route = reader.points("route");
  }
  return file;
}

LoadedWorld loadWorld(const std::filesystem::path& path) {
  LoadedWorld loaded{readWorldFile(path), nullptr};
  try {
    loaded.world = std::make_shared<World>(World::fromImage(grid::loadMapImage(loaded.file.map)));
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("World file '{}': its map cannot be used: {}", path.string(), error.what()));
  }
  return loaded;
}

}  // namespace omega_slam::simulation
