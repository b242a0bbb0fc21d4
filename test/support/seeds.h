#pragma once

#include <cstdint>
#include <vector>

namespace omega_slam::test {

/// Seeds for randomised tests. Three fixed ones, or the single one that the environment variable
/// OMEGA_SLAM_TEST_SEED gives, or as many as OMEGA_SLAM_TEST_SEEDS asks for.
/// A test prints its seed on failure with SCOPED_TRACE.
[[nodiscard]] std::vector<std::uint64_t> seeds();

}  // namespace omega_slam::test
