#include "nodes/common/run_recorder_config.h"

namespace omega_slam {

void read(config::ParameterReader& reader, RunRecorderConfig& config) {
  const config::Range seconds{0.0, 1e6};
  reader.read("world", config.world);
  reader.read("results", config.results);
  reader.read("duration", config.end.duration, seconds);
  reader.read("settle_time", config.end.settle_time, seconds);
  reader.read("settle_deadline", config.end.settle_deadline, seconds);
  reader.read("status_interval", config.status_interval, seconds);
  reader.read("map_frame", config.map_frame);
  reader.read("base_frame", config.base_frame);
  if (config.results.empty()) {
    reader.fault("results must name a folder.");
  }
}

}  // namespace omega_slam
