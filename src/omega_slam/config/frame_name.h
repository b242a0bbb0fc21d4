#pragma once

#include <string>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam::config {

/// Reads the name of a frame: without the leading '/' of tf1, which tf2 refuses.
void readFrame(ParameterReader& reader, const std::string& key, std::string& frame);

}  // namespace omega_slam::config
