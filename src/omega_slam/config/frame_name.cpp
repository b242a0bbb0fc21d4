#include "omega_slam/config/frame_name.h"

namespace omega_slam::config {

void readFrame(ParameterReader& reader, const std::string& key, std::string& frame) {
  reader.read(key, frame);
  if (frame.empty() || frame.front() == '/') {
    reader.fault(key + " must be the name of a frame, without a leading '/'.");
  }
}

}  // namespace omega_slam::config
