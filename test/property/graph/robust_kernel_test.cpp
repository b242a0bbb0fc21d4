#include "omega_slam/graph/robust_kernel.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "omega_slam/graph/graduated_truncation.h"

namespace omega_slam::graph {
namespace {

const KernelKind kKinds[] = {KernelKind::kNone, KernelKind::kHuber, KernelKind::kCauchy,
                             KernelKind::kScaling, KernelKind::kGraduated};

/// What iteratively reweighted least squares needs to find a minimum of the cost at all.
TEST(RobustKernelLaws, TheWeightIsTheSlopeOfTheCost) {
  for (const KernelKind kind : kKinds) {
    for (const double width : {0.5, 1.0, 3.0}) {
      const RobustKernel kernel{kind, width};
      for (double squared = 0.01; squared < 40.0; squared *= 1.3) {
        const double step = 1e-6 * squared;
        const double slope =
            (kernel.at(squared + step).cost - kernel.at(squared - step).cost) / (2.0 * step);
        EXPECT_NEAR(kernel.at(squared).weight, slope, 1e-5) << kernelNames()[size_t(kind)];
      }
    }
  }
}

TEST(RobustKernelLaws, NoCostIsAboveTheSquareAndNoneFalls) {
  for (const KernelKind kind : kKinds) {
    const RobustKernel kernel{kind, 1.5};
    double before = 0.0;
    for (double squared = 0.0; squared < 1e6; squared = 1.5 * squared + 0.01) {
      const RobustCost robust = kernel.at(squared);
      EXPECT_LE(robust.cost, squared * (1.0 + 1e-12));
      EXPECT_GE(robust.cost, before * (1.0 - 1e-12));
      EXPECT_GE(robust.weight, 0.0);
      EXPECT_LE(robust.weight, 1.0);
      before = robust.cost;
    }
  }
}

TEST(RobustKernelLaws, NamesAreReadBack) {
  for (const KernelKind kind : kKinds) {
    EXPECT_EQ(kernelFromName(kernelNames().at(static_cast<std::size_t>(kind))), kind);
  }
  EXPECT_THROW(static_cast<void>(kernelFromName("hubert")), std::invalid_argument);
}

TEST(GraduatedTruncationLaws, StagesLeadFromNearlyEvenWeightsToADecision) {
  const std::vector<double> squared = {0.5, 4.0, 30.0, 900.0};
  GraduatedTruncation stages(3.0, squared);
  ASSERT_TRUE(stages.isNeeded());
  EXPECT_FALSE(areDecided(stages.weights(squared)));
  std::vector<double> before(squared.size(), 1.0);
  int count = 0;
  for (; !areDecided(before) || count == 0; ++count, stages.advance()) {
    ASSERT_LT(count, 100);
    const std::vector<double> weights = stages.weights(squared);
    for (std::size_t i = 1; i < weights.size(); ++i) {
      EXPECT_LE(weights[i], weights[i - 1]);
    }
    before = weights;
  }
  EXPECT_EQ(before, (std::vector<double>{1.0, 1.0, 0.0, 0.0}));
}

TEST(GraduatedTruncationLaws, WhereNothingLiesOffThereIsNothingToDo) {
  EXPECT_FALSE(GraduatedTruncation(3.0, {0.5, 8.9}).isNeeded());
  EXPECT_FALSE(GraduatedTruncation(3.0, {}).isNeeded());
}

}  // namespace
}  // namespace omega_slam::graph
