#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/grid/map_image.h"

namespace omega_slam::grid {

enum class ImageKind : std::uint8_t { kPgm = 0, kPng = 1 };

/// "pgm", "png": also the ending of the file's name.
[[nodiscard]] std::string toString(ImageKind kind);
[[nodiscard]] std::optional<ImageKind> imageKindFromName(const std::string& name);

/// How a map is saved.
struct MapFormat {
  MapMode mode{MapMode::kTrinary};
  ImageKind image{ImageKind::kPgm};

  /// What can't be: kScale shows unknown cells by transparent pixels, which a PGM has not. Empty if
  /// all is well. @param has_unknown_cells as maps nearly always have
  [[nodiscard]] std::string whyNot(bool has_unknown_cells) const;
};

/// Reads `map.yaml` and the image that it names: PGM, PNG, or what else OpenCV reads.
/// @throws std::runtime_error with one sentence that names the file and what is wrong
[[nodiscard]] MapImage loadMapImage(const std::filesystem::path& yaml);

/// What became of a save; truthful.
struct SaveResult {
  bool success{false};
  std::string message;                       ///< one sentence
  std::vector<std::filesystem::path> paths;  ///< files that this save has written
};

/// Writes `<stem>.pgm` or `<stem>.png`, and `<stem>.yaml`, as map_server reads them, each to a
/// temporary name, synced, then renamed; missing folders are made. MapMode says what becomes of the
/// cells. The image comes first: a YAML file never names an image that is not there. Never throws
/// for what the disk does.
[[nodiscard]] SaveResult saveMap(const OccupancyGrid& map, const std::filesystem::path& stem,
                                 const MapFormat& format = {});

}  // namespace omega_slam::grid
