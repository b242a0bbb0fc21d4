#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/determination.h"
#include "omega_slam/matching/matcher_factory.h"

namespace omega_slam::experiments {

struct Contestant {
  std::string name;
  std::unique_ptr<const matching::ScanMatcher> matcher;
};

/// A matcher of the factory, set up for guesses that are off by up to so much. The one place where
/// experiments deviate from defaults, and only as far as their noise forces them to.
[[nodiscard]] matching::MatcherConfig configFor(const std::string& matcher,
                                                const Tolerance& guess_error);

/// Matchers of the factory by name, all where no names are given, in the order of their names.
/// @throws std::invalid_argument if there is none of such a name
[[nodiscard]] std::vector<Contestant> ownMatchers(const Tolerance& guess_error,
                                                  const std::vector<std::string>& names = {});

/// "pcl_icp", the unit of time, and "pcl_ndt".
[[nodiscard]] std::vector<Contestant> peers();

}  // namespace omega_slam::experiments
