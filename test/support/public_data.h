#pragma once

#include <filesystem>
#include <string>

namespace omega_slam::test {

/// A file of the public data sets that some tests use: `relative` below the folder that the
/// environment variable OMEGA_SLAM_DATA names. Empty if the variable is unset or the file absent.
[[nodiscard]] std::filesystem::path publicData(const std::string& relative);

/// Why a test without its data is skipped, and where the data can be had.
[[nodiscard]] std::string howToGetPublicData(const std::string& relative);

}  // namespace omega_slam::test

/// Declares `name`, the path of a public file, or skips the test and says why.
#define OMEGA_SLAM_PUBLIC_DATA(name, relative)                               \
  const std::filesystem::path name = omega_slam::test::publicData(relative); \
  if (name.empty()) {                                                        \
    GTEST_SKIP() << omega_slam::test::howToGetPublicData(relative);          \
  }                                                                          \
  static_assert(true)
