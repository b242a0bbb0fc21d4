#include "omega_slam/mapping/cell_counts.h"

#include <fmt/format.h>

#include <cmath>

namespace omega_slam::mapping {

std::vector<std::string> CellRules::validate() const {
  std::vector<std::string> faults;
  const auto require = [&faults](bool good, const std::string& sentence) {
    if (!good) {
      faults.push_back(sentence);
    }
  };
  // Written so that NaN fails too.
  require(occupied_threshold > 0.0 && occupied_threshold <= 1.0,
          fmt::format("occupied_threshold must be above 0 and at most 1, but it is {}.",
                      occupied_threshold));
  require(free_threshold >= 0.0 && !(free_threshold > occupied_threshold),
          fmt::format("free_threshold must be 0 or above and at most occupied_threshold ({}), but "
                      "it is {}.",
                      occupied_threshold, free_threshold));
  require(min_observations >= 1,
          fmt::format("min_observations must be 1 or more, but it is {}.", min_observations));
  require(prior >= 0.0 && prior <= 1.0,
          fmt::format("prior must be in [0, 1], but it is {}.", prior));
  require(prior_weight >= 0.0 && prior_weight <= 1000.0,
          fmt::format("prior_weight must be in [0, 1000], but it is {}.", prior_weight));
  return faults;
}

std::int8_t CellRules::verdict(const CellCounts& counts) const {
  if (!isKnown(counts)) {
    return grid::kUnknown;
  }
  const double likely = probability(counts);
  if (likely >= occupied_threshold) {
    return grid::kOccupied;
  }
  return likely < free_threshold ? grid::kFree : grid::kUnknown;
}

std::int8_t CellRules::percentage(const CellCounts& counts) const {
  return isKnown(counts) ? static_cast<std::int8_t>(std::lround(100.0 * probability(counts)))
                         : grid::kUnknown;
}

}  // namespace omega_slam::mapping
