#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace omega_slam::config {

/// The one document of a YAML file.
/// @throws ConfigurationError with a sentence that names the file, and the line where there is one:
/// the file can't be read, is empty, holds several documents, or is not YAML
[[nodiscard]] YAML::Node loadYamlFile(const std::string& path);

}  // namespace omega_slam::config
