#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "omega_slam/grid/occupancy_grid.h"

namespace omega_slam::mapping {

/// How many sweeps have seen a cell occupied, and how many free.
struct CellCounts {
  std::uint32_t hits{0};
  std::uint32_t misses{0};

  [[nodiscard]] std::uint64_t observations() const { return std::uint64_t{hits} + misses; }
};

/// What counts say of a cell.
struct CellRules {
  double occupied_threshold{0.5};  ///< a cell is a wall from this probability on
  double free_threshold{0.5};      ///< a cell is free below it; between both, unknown
  int min_observations{1};         ///< cells that fewer sweeps have touched stay unknown
  double prior{0.5};               ///< probability of a wall before anything was seen
  double prior_weight{1.0};        ///< observations that the prior counts as

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each

  [[nodiscard]] bool isKnown(const CellCounts& counts) const {
    return counts.observations() >= static_cast<std::uint64_t>(min_observations);
  }
  /// Probability of a wall: the mean of the beta distribution that the prior and the counts lead
  /// to. Of a known cell only.
  [[nodiscard]] double probability(const CellCounts& counts) const {
    return (counts.hits + prior * prior_weight) /
           (static_cast<double>(counts.observations()) + prior_weight);
  }
  /// -1, 0 or 100.
  [[nodiscard]] std::int8_t verdict(const CellCounts& counts) const;
  /// -1, or the probability in percent.
  [[nodiscard]] std::int8_t percentage(const CellCounts& counts) const;
};

}  // namespace omega_slam::mapping
