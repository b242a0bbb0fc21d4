#include "support/match_results.h"

#include <gtest/gtest.h>

#include <cmath>

namespace omega_slam::test {

void expectFinite(const matching::MatchResult& result) {
  EXPECT_TRUE(result.T_reference_scan.isFinite());
  EXPECT_TRUE(result.covariance.allFinite());
  EXPECT_TRUE(std::isfinite(result.residual));
  EXPECT_GE(result.confidence, 0.0);
  EXPECT_LE(result.confidence, 1.0);
  EXPECT_TRUE(!result.open_direction || result.open_direction->allFinite());
}

}  // namespace omega_slam::test
