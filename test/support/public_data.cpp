#include "support/public_data.h"

#include <cstdlib>
#include <system_error>

namespace omega_slam::test {

std::filesystem::path publicData(const std::string& relative) {
  const char* folder = std::getenv("OMEGA_SLAM_DATA");
  if (folder == nullptr || *folder == '\0') {
    return {};
  }
  const std::filesystem::path path = std::filesystem::path(folder) / relative;
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) ? path : std::filesystem::path();
}

std::string howToGetPublicData(const std::string& relative) {
  return "The public file '" + relative +
         "' is not there: set OMEGA_SLAM_DATA to a folder that holds it. The logs are those of the "
         "Robotics Data Set Repository (Radish); their ground-truth relations come with the SLAM "
         "benchmark of the University of Freiburg (Kuemmerle et al., Autonomous Robots, 2009).";
}

}  // namespace omega_slam::test
