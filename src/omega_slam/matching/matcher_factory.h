#pragma once

#include <memory>
#include <string>
#include <vector>

#include "omega_slam/matching/correlative_matcher.h"
#include "omega_slam/matching/hill_climbing_matcher.h"
#include "omega_slam/matching/icp_matcher.h"
#include "omega_slam/matching/map_matcher.h"
#include "omega_slam/matching/particle_matcher.h"
#include "omega_slam/matching/point_to_line_matcher.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Which matcher, and how each of them works: a choice at run time.
struct MatcherConfig {
  std::string matcher{"scan_to_map"};  ///< one of matcherNames()
  MatchConfig match;                   ///< of all
  CorrelativeMatcherConfig correlative;
  HillClimbingConfig hill_climbing;
  IcpMatcherConfig icp;
  ParticleConfig particles;
  PointToLineMatcherConfig point_to_line;
  MapMatcherConfig scan_to_map;

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// The names that MatcherConfig::matcher may have.
[[nodiscard]] std::vector<std::string> matcherNames();

/// @throws std::invalid_argument
[[nodiscard]] std::unique_ptr<const ScanMatcher> makeMatcher(const MatcherConfig& config);

}  // namespace omega_slam::matching
