#pragma once

#include <filesystem>
#include <string>

#include "omega_slam/grid/map_image.h"

namespace omega_slam::grid {

/// What stands in a map's YAML file.
struct MapDescription {
  std::string image_name;  ///< of the image file, from the folder of the YAML file
  MapImage map;            ///< without pixels, and without width and height
};

/// Reads `map.yaml`. As for map_server, every key but `mode` must be there; others than
/// map_server's are refused, since they may be misspelt. Images are axis parallel here: a yaw of
/// the origin other than 0 is refused.
/// @throws std::runtime_error with one sentence that names the file and the key
[[nodiscard]] MapDescription readDescription(const std::filesystem::path& yaml);

/// The text of such a file, which is read as the same, to the bit. The mode is left out where it is
/// trinary, which programs older than modes read too.
[[nodiscard]] std::string toYaml(const MapDescription& description);

/// The shortest decimal number that is read as the same value.
[[nodiscard]] std::string numberText(double value);

}  // namespace omega_slam::grid
