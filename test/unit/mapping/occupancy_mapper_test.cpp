#include "omega_slam/mapping/occupancy_mapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "omega_slam/geometry/angle.h"
#include "support/rooms.h"

namespace omega_slam::mapping {
namespace {

using geometry::Pose2;
using sensing::Beam;
using sensing::BeamKind;
using sensing::Sweep;

constexpr std::int8_t kFree = grid::kFree;
constexpr std::int8_t kWall = grid::kOccupied;
constexpr std::int8_t kDark = grid::kUnknown;

Sweep sweepOf(std::vector<Beam> beams) {
  Sweep sweep;
  sweep.angle_increment = 0.01;
  sweep.beams = std::move(beams);
  return sweep;
}

/// Cells of 1 m make results easy to write down.
OccupancyMapperConfig coarse() {
  OccupancyMapperConfig config;
  config.resolution = 1.0;
  return config;
}

std::int8_t valueAt(const grid::OccupancyGrid& map, double x, double y) {
  const grid::Cell cell = map.geometry.cellAt({x, y});
  return map.geometry.contains(cell) ? map.at(cell) : kDark;
}

TEST(OccupancyMapper, EmptyWithoutSweeps) {
  const grid::OccupancyGrid map = OccupancyMapper().render();
  EXPECT_EQ(map.geometry.width, 0);
  EXPECT_EQ(map.geometry.height, 0);
  EXPECT_TRUE(map.cells.empty());
  EXPECT_DOUBLE_EQ(map.geometry.resolution, 0.05);
}

TEST(OccupancyMapper, AReturnIsFreeAlongAndAWallAtTheEnd) {
  OccupancyMapper mapper(coarse());
  EXPECT_EQ(mapper.add(sweepOf({{{3.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  const grid::OccupancyGrid map = mapper.render();
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{kFree, kFree, kFree, kWall}));
  EXPECT_EQ(map.geometry.width, 4);
  EXPECT_EQ(map.geometry.height, 1);
  EXPECT_EQ(map.geometry.origin, Eigen::Vector2d(0.0, 0.0));
}

TEST(OccupancyMapper, NoReturnIsFreeUpToItsEnd) {
  OccupancyMapper mapper(coarse());
  EXPECT_EQ(mapper.add(sweepOf({{{2.0, 0.0}, BeamKind::kNoReturn}}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kFree, kFree, kFree}));
}

TEST(OccupancyMapper, AnUnknownBeamSaysNothing) {
  OccupancyMapper mapper(coarse());
  EXPECT_EQ(mapper.add(sweepOf({{{2.0, 0.0}, BeamKind::kUnknown}}), {0.5, 0.5, 0.0}), "");
  EXPECT_TRUE(mapper.render().cells.empty());
}

TEST(OccupancyMapper, ReturnsBeyondTheMaximalRangeAreFreeUpToThere) {
  OccupancyMapperConfig config = coarse();
  config.max_range = 2.0;
  OccupancyMapper mapper(config);
  EXPECT_EQ(mapper.add(sweepOf({{{9.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kFree, kFree, kFree}));
}

TEST(OccupancyMapper, BeamsStartAtTheLaser) {
  Sweep sweep = sweepOf({{{3.0, 0.0}, BeamKind::kReturn}});
  sweep.T_base_laser = {2.0, 0.0, 0.0};
  OccupancyMapper mapper(coarse());
  // The robot looks along +y: laser at y = 2.5, end at y = 3.5.
  EXPECT_EQ(mapper.add(sweep, {0.5, 0.5, geometry::kPi / 2}), "");
  const grid::OccupancyGrid map = mapper.render();
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{kFree, kWall}));
  EXPECT_EQ(map.geometry.origin, Eigen::Vector2d(0.0, 2.0));
}

TEST(OccupancyMapper, AHitWinsOverMissesOfTheSameSweep) {
  // The other two beams pass through the cell in which the middle one ends. Did even one miss count
  // beside the hit, the share of hits would be too low.
  OccupancyMapperConfig config = coarse();
  config.rules.occupied_threshold = 0.9;
  config.rules.prior_weight = 0.0;
  OccupancyMapper mapper(config);
  EXPECT_EQ(mapper.add(sweepOf({{{4.0, 0.1}, BeamKind::kReturn},
                                {{2.0, 0.0}, BeamKind::kReturn},
                                {{4.0, -0.1}, BeamKind::kReturn}}),
                       {0.5, 0.5, 0.0}),
            "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kFree, kFree, kWall, kFree, kWall}));
}

TEST(OccupancyMapper, ASweepCountsOnceInACell) {
  // One sweep with five beams through cell 1, then one that ends there: one against one.
  OccupancyMapper mapper(coarse());
  const Beam far{{3.0, 0.0}, BeamKind::kReturn};
  EXPECT_EQ(mapper.add(sweepOf({far, far, far, far, far}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.add(sweepOf({{{1.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(valueAt(mapper.render(), 1.5, 0.5), kWall);
  EXPECT_EQ(mapper.add(sweepOf({far}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(valueAt(mapper.render(), 1.5, 0.5), kFree);  // one against two
}

TEST(OccupancyMapper, ThresholdIsInclusiveAndObservationsAreRequired) {
  OccupancyMapperConfig config = coarse();
  config.rules.occupied_threshold = 2.0 / 3.0;
  config.rules.prior_weight = 0.0;
  config.rules.min_observations = 3;
  OccupancyMapper mapper(config);
  const Sweep hit = sweepOf({{{1.0, 0.0}, BeamKind::kReturn}});
  const Sweep miss = sweepOf({{{2.0, 0.0}, BeamKind::kNoReturn}});
  EXPECT_EQ(mapper.add(hit, {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.add(miss, {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kDark, kDark, kDark}));
  EXPECT_EQ(mapper.add(hit, {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kFree, kWall, kDark}));
}

TEST(OccupancyMapper, GrowsInAllDirections) {
  OccupancyMapper mapper(coarse());
  for (const double reach : {3.0, 40.0, 500.0}) {
    for (const Eigen::Vector2d& way : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1),
                                       Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, -1)}) {
      ASSERT_EQ(mapper.add(sweepOf({{reach * way, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
    }
  }
  const grid::OccupancyGrid map = mapper.render();
  EXPECT_EQ(map.geometry.width, 1001);
  EXPECT_EQ(map.geometry.height, 1001);
  EXPECT_EQ(map.geometry.origin, Eigen::Vector2d(-500.0, -500.0));
  EXPECT_EQ(valueAt(map, 500.5, 0.5), kWall);
  EXPECT_EQ(valueAt(map, 0.5, -499.5), kWall);
  EXPECT_EQ(valueAt(map, 0.5, 0.5), kFree);
  EXPECT_EQ(valueAt(map, 3.5, 0.5), kFree);  // two longer beams went through
  EXPECT_EQ(valueAt(map, 30.5, 30.5), kDark);
}

TEST(OccupancyMapper, AWallSeenAtAGrazingAngleStays) {
  // Close along the lower wall of a long room: each beam's end cell is crossed by its neighbours.
  const Eigen::Vector2d half(10.0, 1.975);
  OccupancyMapperConfig config;
  config.rules.occupied_threshold = 0.9;
  config.rules.prior_weight = 0.0;
  OccupancyMapper mapper(config);
  const Pose2 pose{-9.0, -1.9, 0.3};
  EXPECT_EQ(mapper.add(test::sweepInRoom(half, pose, {0.1, 0.02, 0.1}, 7200), pose), "");
  const grid::OccupancyGrid map = mapper.render();
  // Within 2 m of the laser neighbouring beams end less than a cell apart.
  for (double x = -9.9; x < -7.0; x += 0.05) {
    EXPECT_EQ(valueAt(map, x, -1.98), kWall) << x;
  }
}

TEST(OccupancyMapper, DrawsARoom) {
  const Eigen::Vector2d half(2.025, 1.525);
  OccupancyMapper mapper;
  for (const Pose2& pose : {Pose2{0.0, 0.0, 0.5}, Pose2{1.2, -0.7, 3.0}, Pose2{-1.5, 0.9, -2.0}}) {
    ASSERT_EQ(mapper.add(test::sweepInRoom(half, pose, {0.2, -0.1, 1.0}, 2000), pose), "");
  }
  const grid::OccupancyGrid map = mapper.render();
  EXPECT_EQ(map.geometry.width, 82);  // walls included
  EXPECT_EQ(map.geometry.height, 62);
  for (int y = 0; y < map.geometry.height; ++y) {
    for (int x = 0; x < map.geometry.width; ++x) {
      const bool edge = x == 0 || y == 0 || x == 81 || y == 61;
      ASSERT_EQ(map.at({x, y}), edge ? kWall : kFree) << x << ' ' << y;
    }
  }
}

TEST(OccupancyMapper, ClearForgetsAll) {
  OccupancyMapper mapper(coarse());
  EXPECT_EQ(mapper.add(sweepOf({{{3.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  mapper.clear();
  EXPECT_TRUE(mapper.render().cells.empty());
  EXPECT_EQ(mapper.add(sweepOf({{{1.0, 0.0}, BeamKind::kReturn}}), {90.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{kFree, kWall}));
}

TEST(OccupancyMapper, WhatWasTakenOutHasNeverBeenIn) {
  OccupancyMapper mapper(coarse());
  ASSERT_EQ(mapper.add(sweepOf({{{3.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  const grid::OccupancyGrid before = mapper.render();
  ASSERT_EQ(mapper.add(sweepOf({{{0.0, 900.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(mapper.render().geometry.height, 901);
  mapper.takeOut(1);
  mapper.takeOut(7);  // there is none
  const grid::OccupancyGrid after = mapper.render();
  EXPECT_EQ(after.cells, before.cells);
  EXPECT_EQ(after.geometry.height, 1);
}

TEST(OccupancyMapper, PuttingASweepInAgainMovesIt) {
  OccupancyMapper mapper(coarse());
  const auto sweep = std::make_shared<const Sweep>(sweepOf({{{1.0, 0.0}, BeamKind::kReturn}}));
  ASSERT_EQ(mapper.put({4, sweep, {0.5, 0.5, 0.0}}), "");
  ASSERT_EQ(mapper.put({4, sweep, {0.5, 5.5, 0.0}}), "");
  const grid::OccupancyGrid map = mapper.render();
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{kFree, kWall}));
  EXPECT_EQ(map.geometry.origin.y(), 5.0);
  EXPECT_EQ(mapper.drawn().size(), 1U);
}

TEST(OccupancyMapper, AMadPoseThatWasTakenOutLeavesRoom) {
  OccupancyMapperConfig config = coarse();
  config.max_extent = 1000.0;
  OccupancyMapper mapper(config);
  const auto sweep = std::make_shared<const Sweep>(sweepOf({{{1.0, 0.0}, BeamKind::kReturn}}));
  ASSERT_EQ(mapper.put({0, sweep, {-600.0, 0.0, 0.0}}), "");
  EXPECT_NE(mapper.put({1, sweep, {600.0, 0.0, 0.0}}), "");
  mapper.takeOut(0);
  EXPECT_EQ(mapper.put({1, sweep, {600.0, 0.0, 0.0}}), "");
}

TEST(OccupancyMapper, SnapshotsStandStill) {
  OccupancyMapper mapper(coarse());
  ASSERT_EQ(mapper.add(sweepOf({{{3.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  const MapSnapshot snapshot = mapper.snapshot();
  const grid::OccupancyGrid before = render(snapshot, MapLayer::kVerdict);
  ASSERT_EQ(mapper.add(sweepOf({{{5.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  ASSERT_EQ(mapper.add(sweepOf({{{5.0, 0.0}, BeamKind::kReturn}}), {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(render(snapshot, MapLayer::kVerdict).cells, before.cells);
  EXPECT_NE(mapper.render().cells, before.cells);
  mapper.clear();
  EXPECT_EQ(render(snapshot, MapLayer::kVerdict).cells, before.cells);
}

TEST(OccupancyMapper, ProbabilitiesAreMeansOfABetaDistribution) {
  OccupancyMapper mapper(coarse());
  const Sweep hit = sweepOf({{{1.0, 0.0}, BeamKind::kReturn}});
  ASSERT_EQ(mapper.add(hit, {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(render(mapper.snapshot(), MapLayer::kProbability).cells,
            (std::vector<std::int8_t>{25, 75}));
  ASSERT_EQ(mapper.add(hit, {0.5, 0.5, 0.0}), "");
  EXPECT_EQ(render(mapper.snapshot(), MapLayer::kProbability).cells,
            (std::vector<std::int8_t>{17, 83}));
}

TEST(CellRules, BetweenTheThresholdsACellIsUnknown) {
  CellRules rules;
  rules.free_threshold = 0.3;
  rules.occupied_threshold = 0.7;
  EXPECT_EQ(rules.verdict({0, 1}), kFree);
  EXPECT_EQ(rules.verdict({1, 1}), kDark);
  EXPECT_EQ(rules.verdict({1, 0}), kWall);
  EXPECT_EQ(rules.verdict({0, 0}), kDark);
  EXPECT_EQ(rules.percentage({0, 0}), kDark);
}

TEST(CellRules, ThePriorIsWhatTheFirstSightMustOutweigh) {
  CellRules rules;
  rules.prior = 0.1;
  rules.prior_weight = 4.0;
  EXPECT_EQ(rules.percentage({1, 0}), 28);
  EXPECT_EQ(rules.verdict({1, 0}), kFree);
  EXPECT_EQ(rules.verdict({4, 0}), kWall);
}

TEST(CellRules, NamesEveryFault) {
  EXPECT_TRUE(CellRules().validate().empty());
  CellRules rules;
  rules.free_threshold = 0.6;
  rules.prior = std::nan("");
  rules.prior_weight = -1.0;
  EXPECT_EQ(rules.validate().size(), 3U);
}

TEST(OccupancyMapperConfig, NamesEveryFault) {
  EXPECT_TRUE(OccupancyMapperConfig().validate().empty());
  OccupancyMapperConfig config;
  config.resolution = 0.0;
  config.max_range = -1.0;
  config.rules.occupied_threshold = std::nan("");
  config.rules.min_observations = 0;
  config.max_extent = std::numeric_limits<double>::infinity();
  const std::vector<std::string> faults = config.validate();
  ASSERT_EQ(faults.size(), 5U);
  EXPECT_EQ(faults[0], "resolution must be above 0 m, but it is 0.");
  EXPECT_EQ(faults[1], "max_range must be 0 (no limit) or above, but it is -1.");
  EXPECT_EQ(faults[2], "max_extent must be above 0 m, but it is inf.");
  EXPECT_EQ(faults[3], "occupied_threshold must be above 0 and at most 1, but it is nan.");
  EXPECT_EQ(faults[4], "min_observations must be 1 or more, but it is 0.");
  EXPECT_THROW(OccupancyMapper{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::mapping
