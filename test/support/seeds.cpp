#include "support/seeds.h"

#include <cstdlib>
#include <string>

namespace omega_slam::test {

std::vector<std::uint64_t> seeds() {
  if (const char* one = std::getenv("OMEGA_SLAM_TEST_SEED")) {
    return {std::stoull(one)};
  }
  std::uint64_t count = 3;
  if (const char* many = std::getenv("OMEGA_SLAM_TEST_SEEDS")) {
    count = std::stoull(many);
  }
  std::vector<std::uint64_t> result;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    result.push_back(seed);
  }
  return result;
}

}  // namespace omega_slam::test
