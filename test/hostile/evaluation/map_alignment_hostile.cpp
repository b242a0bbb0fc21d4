#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "omega_slam/evaluation/feature_alignment.h"
#include "omega_slam/evaluation/map_correlation.h"
#include "support/buildings.h"
#include "support/drawn_map.h"

namespace omega_slam::evaluation {
namespace {

grid::OccupancyGrid building() {
  std::mt19937_64 random(1);
  return test::randomBuilding(random);
}

TEST(MapAlignmentHostile, MapsWithoutWallsCannotBeAligned) {
  const grid::OccupancyGrid open = grid::makeGrid({0.05, {0.0, 0.0}, 50, 40}, grid::kFree);
  for (const grid::OccupancyGrid& bad : {grid::OccupancyGrid{}, open}) {
    EXPECT_FALSE(alignByCorrelation(bad, building()));
    EXPECT_FALSE(alignByCorrelation(building(), bad));
    for (const auto& features :
         {alignByFeatures(bad, building()), alignByFeatures(building(), bad)}) {
      EXPECT_FALSE(features.T_truth_map);
      EXPECT_EQ(features.reason.back(), '.');
    }
  }
}

TEST(MapAlignmentHostile, TinyAndThinMapsAreAligned) {
  const grid::OccupancyGrid cell = test::drawnMap({"#"});
  const grid::OccupancyGrid line = test::drawnMap({"#....#..#.#"});
  for (const grid::OccupancyGrid& odd : {cell, line}) {
    for (const auto& found : {alignByCorrelation(odd, line), alignByCorrelation(odd, building()),
                              alignByCorrelation(building(), odd)}) {
      ASSERT_TRUE(found);
      EXPECT_TRUE(found->T_truth_map.isFinite());
    }
    EXPECT_FALSE(alignByFeatures(odd, building()).T_truth_map);
  }
}

TEST(MapAlignmentHostile, OriginsMayBeFarAway) {
  const grid::OccupancyGrid truth = building();
  grid::OccupancyGrid far = truth;
  far.geometry.origin += Eigen::Vector2d(1e6, -1e6);
  const auto found = alignByCorrelation(far, truth);
  ASSERT_TRUE(found);
  const Eigen::Vector2d corner = found->T_truth_map * far.geometry.origin;
  EXPECT_LT((corner - truth.geometry.origin).norm(), 0.05);
}

TEST(MapAlignmentHostile, ResolutionsMayDifferByFar) {
  grid::OccupancyGrid coarse = test::drawnMap({"######", "#..#.#", "#....#", "#.####", "######"});
  coarse.geometry.resolution = 2.0;
  EXPECT_TRUE(alignByCorrelation(coarse, building()));
  EXPECT_TRUE(alignByCorrelation(building(), coarse));
}

TEST(MapAlignmentHostile, OptionsAreChecked) {
  MapCorrelationOptions options;
  options.headings = 0;
  options.candidates = -1;
  EXPECT_EQ(options.validate().size(), 2U);
  EXPECT_THROW(static_cast<void>(alignByCorrelation(building(), building(), options)),
               std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::evaluation
