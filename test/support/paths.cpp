#include "support/paths.h"

#include <cstdlib>

namespace omega_slam::test {

std::filesystem::path sourceFolder() { return OMEGA_SLAM_SOURCE_DIR; }

std::optional<std::filesystem::path> dataFile(const std::string& name) {
  const char* folder = std::getenv("OMEGA_SLAM_DATA");
  if (folder == nullptr) {
    return std::nullopt;
  }
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  return std::filesystem::exists(path) ? std::optional(path) : std::nullopt;
}

std::string missingData(const std::string& name) {
  return "There is no " + name +
         " below the folder that the environment variable OMEGA_SLAM_DATA names. The data is "
         "public, but not ours to ship: the logs are in the Robotics Data Set Repository (Radish) "
         "and on the SLAM benchmark pages of the University of Freiburg.";
}

}  // namespace omega_slam::test
