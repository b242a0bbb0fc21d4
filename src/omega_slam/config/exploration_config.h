#pragma once

#include <string>

#include "omega_slam/config/parameter_reader.h"
#include "omega_slam/exploration/explorer_config.h"

namespace omega_slam::config {

/// Of the node frontier_explorer; config/exploration.yaml explains the keys.
struct FrontierExplorerNodeConfig {
  exploration::ExplorerConfig explorer;
  bool auto_start{true};  ///< begins by itself, as soon as there are a map and a pose
  std::string map_frame{"map"};
  std::string base_frame{"base_footprint"};
  double update_rate{5.0};    ///< [Hz] at which it looks at what has happened
  std::string save_folder{};  ///< map and graph are saved there in the end; empty: they are not
};

/// Reads its keys and does not call finish().
void read(ParameterReader& reader, FrontierExplorerNodeConfig& config);

}  // namespace omega_slam::config
