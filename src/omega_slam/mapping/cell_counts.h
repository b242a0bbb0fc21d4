#pragma once

#include <cstdint>
#include <limits>

namespace omega_slam::mapping {

/// How often a cell was seen occupied and seen free. Counts stay at their maximum rather than wrap.
struct CellCounts {
  std::uint32_t hits{0};
  std::uint32_t misses{0};

  void hit() { count(hits); }
  void miss() { count(misses); }
  [[nodiscard]] std::uint64_t observations() const { return std::uint64_t{hits} + misses; }

 private:
  static void count(std::uint32_t& value) {
    value += value < std::numeric_limits<std::uint32_t>::max() ? 1U : 0U;
  }
};

}  // namespace omega_slam::mapping
