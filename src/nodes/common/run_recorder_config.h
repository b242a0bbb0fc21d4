#pragma once

#include <string>

#include "nodes/common/run_recorder_end.h"
#include "omega_slam/config/parameter_reader.h"

namespace omega_slam {

/// Parameters of the node run_recorder; config/run_recorder.yaml explains them.
struct RunRecorderConfig {
  std::string world;               ///< path of the world file; empty: nothing is known of the world
  std::string results{"results"};  ///< folder that is written to, made where it is missing
  RunEndConfig end;
  double status_interval{5.0};  ///< [s] of wall time between lines, where they are not a terminal's
  std::string map_frame{"map"};
  std::string base_frame{"base_footprint"};
};

/// Reads all keys and does not call finish().
void read(config::ParameterReader& reader, RunRecorderConfig& config);

}  // namespace omega_slam
