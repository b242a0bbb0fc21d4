#include "omega_slam/matching/likelihood_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using grid::Cell;

constexpr int kReach = 7;
constexpr int kLevels = 5;

std::vector<Cell> randomCells(std::mt19937_64& random) {
  std::uniform_int_distribution<int> index(-60, 60);
  std::vector<Cell> cells;
  for (int i = 0; i < 25; ++i) {
    const int x = index(random);
    cells.emplace_back(x, index(random));
  }
  return cells;
}

/// From the definition.
int likelihoodAt(const Cell& cell, const std::vector<Cell>& surfaces) {
  int nearest = kReach * kReach;
  for (const Cell& surface : surfaces) {
    nearest = std::min(nearest, (surface - cell).squaredNorm());
  }
  return static_cast<int>(
      std::lround(LikelihoodPyramid::kFull * (1.0 - double(nearest) / (kReach * kReach))));
}

TEST(LikelihoodPyramidLaws, FinestLevelIsTheLikelihoodItself) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto surfaces = randomCells(random);
    const LikelihoodPyramid pyramid(surfaces, kReach, 1);
    for (int y = -75; y <= 75; ++y) {
      for (int x = -75; x <= 75; ++x) {
        ASSERT_EQ(pyramid.at(0, x, y), likelihoodAt({x, y}, surfaces)) << x << " " << y;
      }
    }
  }
}

TEST(LikelihoodPyramidLaws, CoarserLevelsBoundAllThatTheySpeakFor) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const LikelihoodPyramid pyramid(randomCells(random), kReach, kLevels);
    std::uniform_int_distribution<int> index(-80, 80);
    for (int level = 1; level < kLevels; ++level) {
      const int side = 1 << LikelihoodPyramid::blockShift(level);
      const int slack = LikelihoodPyramid::slack(level);
      for (int i = 0; i < 100; ++i) {
        const int block_x = index(random) / side;
        const int block_y = index(random) / side;
        int greatest = 0;
        for (int y = block_y * side - slack; y < (block_y + 1) * side + slack; ++y) {
          for (int x = block_x * side - slack; x < (block_x + 1) * side + slack; ++x) {
            greatest = std::max(greatest, pyramid.at(0, x, y));
          }
        }
        ASSERT_EQ(pyramid.at(level, block_x, block_y), greatest) << "level " << level;
      }
    }
  }
}

TEST(LikelihoodPyramidLaws, WithoutSurfacesNothingIsLikely) {
  const LikelihoodPyramid pyramid({}, kReach, kLevels);
  EXPECT_EQ(pyramid.at(0, 0, 0), 0);
  EXPECT_EQ(pyramid.at(kLevels - 1, -1, 3), 0);
}

}  // namespace
}  // namespace omega_slam::matching
