#include "omega_slam/grid/map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_description.h"
#include "omega_slam/grid/pgm.h"
#include "omega_slam/grid/png.h"

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

std::string encode(const MapImage& map, ImageKind kind) {
  const int width = map.geometry.width;
  const GrayImage image{width, map.geometry.height, upsideDown(map.pixels, width),
                        upsideDown(map.opacity, width)};
  return kind == ImageKind::kPng
             ? encodePng(image)
             : encodePgm(image, fmt::format("{} m/pix", numberText(map.geometry.resolution)));
}

std::string whyNotSavable(const OccupancyGrid& map, const MapFormat& format) {
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
  const bool has_unknown = std::any_of(map.cells.begin(), map.cells.end(),
                                       [](std::int8_t cell) { return cell < 0 || cell > 100; });
  const std::string fault = format.whyNot(has_unknown);
  return fault.empty() ? fault : fmt::format("The map was not saved: {}", fault);
}

fs::path withEnding(const fs::path& stem, const std::string& ending) {
  fs::path path = stem;
  path += ending;  // not replace_extension: "map.v2" must keep its "v2"
  return path;
}

}  // namespace

std::string toString(ImageKind kind) { return kind == ImageKind::kPng ? "png" : "pgm"; }

std::optional<ImageKind> imageKindFromName(const std::string& name) {
  for (const ImageKind kind : {ImageKind::kPgm, ImageKind::kPng}) {
    if (toString(kind) == name) {
      return kind;
    }
  }
  return std::nullopt;
}

std::string MapFormat::whyNot(bool has_unknown_cells) const {
  return mode == MapMode::kScale && image == ImageKind::kPgm && has_unknown_cells
             ? "the mode scale shows unknown cells by transparent pixels, which a PGM does not "
               "have; a PNG does."
             : "";
}

SaveResult saveMap(const OccupancyGrid& map, const fs::path& stem, const MapFormat& format) {
  SaveResult result;
  result.message = whyNotSavable(map, format);
  if (!result.message.empty()) {
    return result;
  }
  const fs::path image_path = withEnding(stem, '.' + toString(format.image));
  const fs::path yaml_path = withEnding(stem, ".yaml");
  const MapImage image = toMapImage(map, format.mode);
  const auto write = [&result](const fs::path& path, const std::string& content) {
    result.message = writeFileAtomically(path, content);
    if (result.message.empty()) {
      result.paths.push_back(path);
    }
    return result.message.empty();
  };
  result.success = write(image_path, encode(image, format.image)) &&
                   write(yaml_path, toYaml({image_path.filename().string(), image}));
  if (result.success) {
    result.message =
        fmt::format("The map ({} x {} cells) is saved as {} and {}.", map.geometry.width,
                    map.geometry.height, image_path.string(), yaml_path.string());
  }
  return result;
}

}  // namespace omega_slam::grid
