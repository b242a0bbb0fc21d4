#pragma once

#include <string>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam::config {

/// Of the node map_publisher; config/map_publisher.yaml explains the keys.
struct MapPublisherNodeConfig {
  std::string map_file;  ///< required
  std::string frame_id{"map"};
};

/// Reads its keys and does not call finish().
void read(ParameterReader& reader, MapPublisherNodeConfig& config);

}  // namespace omega_slam::config
