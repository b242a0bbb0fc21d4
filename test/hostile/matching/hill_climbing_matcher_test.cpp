#include "omega_slam/matching/hill_climbing_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace omega_slam::matching {
namespace {

TEST(HillClimbingMatcherHostile, SenselessConfigurationThrows) {
  HillClimbingConfig config;
  config.direction_step = 0.0;
  config.distance_step = -1.0;
  config.rotation_step = NAN;
  config.distance_reach = -0.1;
  config.rotation_reach = -0.1;
  config.shrink = 1.1;
  config.rounds = -1;
  config.error_cap = 0.0;
  EXPECT_EQ(config.validate().size(), 8U);
  EXPECT_THROW(HillClimbingMatcher{config}, std::invalid_argument);
  MatchConfig common;
  common.min_returns = 0;
  EXPECT_THROW(HillClimbingMatcher({}, common), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching
