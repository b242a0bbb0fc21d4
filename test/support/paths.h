#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace omega_slam::test {

/// The package's own folder, for tests of the files that it ships.
[[nodiscard]] std::filesystem::path sourceFolder();

/// A file of the recorded data, or none where the environment variable OMEGA_SLAM_DATA does not
/// lead to one.
/// @param name below the data's folder, such as "bags/intel_2726.bag"
[[nodiscard]] std::optional<std::filesystem::path> dataFile(const std::string& name);

/// For GTEST_SKIP: why a test of recorded data is not run, and where the data can be had.
[[nodiscard]] std::string missingData(const std::string& name);

}  // namespace omega_slam::test
