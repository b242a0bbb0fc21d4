#include "omega_slam/config/map_publisher_config.h"

#include "omega_slam/config/frame_name.h"

namespace omega_slam::config {

void read(ParameterReader& reader, MapPublisherNodeConfig& config) {
  reader.read("map_file", config.map_file);
  if (config.map_file.empty()) {
    reader.fault("map_file must be the path of a map's YAML file.");
  }
  readFrame(reader, "frame_id", config.frame_id);
}

}  // namespace omega_slam::config
