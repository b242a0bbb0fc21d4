#include "omega_slam/mapping/map_update.h"

#include <gtest/gtest.h>

#include <limits>

namespace omega_slam::mapping {
namespace {

using geometry::Pose2;

/// A sweep with one beam of 4 m straight ahead.
PlacedSweep placed(SweepId id, const Pose2& T_map_base) {
  sensing::Sweep sweep;
  sweep.angle_increment = 0.01;
  sweep.beams = {{{4.0, 0.0}, sensing::BeamKind::kReturn}};
  return {id, std::make_shared<const sensing::Sweep>(sweep), T_map_base};
}

class MapUpdateTest : public ::testing::Test {
 protected:
  static OccupancyMapperConfig config() {
    OccupancyMapperConfig config;
    config.resolution = 0.1;
    return config;
  }

  /// Three sweeps that are in the map.
  void SetUp() override {
    for (SweepId id = 0; id < 3; ++id) {
      sweeps_.push_back(placed(id, {0.0, static_cast<double>(id), 0.0}));
    }
    EXPECT_EQ(update(mapper_, sweeps_).drawn, 3U);
  }

  void expectAsDrawnAtOnce() {
    OccupancyMapper fresh(config());
    EXPECT_EQ(update(fresh, sweeps_).drawn, sweeps_.size());
    EXPECT_EQ(mapper_.render().cells, fresh.render().cells);
    EXPECT_EQ(mapper_.render().geometry.origin, fresh.render().geometry.origin);
  }

  OccupancyMapper mapper_{config()};
  std::vector<PlacedSweep> sweeps_;
};

TEST_F(MapUpdateTest, OnlyNewSweepsAreDrawnWhilePosesStand) {
  sweeps_[0].T_map_base.x = 0.04;  // less than half a cell
  sweeps_.push_back(placed(3, {0.0, 3.0, 0.0}));
  const UpdateReport report = update(mapper_, sweeps_);
  EXPECT_EQ(report.drawn, 1U);
  EXPECT_EQ(report.moved, 0U);
  EXPECT_EQ(mapper_.drawn().size(), 4U);
}

TEST_F(MapUpdateTest, SmallStepsAddUp) {
  sweeps_[0].T_map_base.x = 0.04;
  EXPECT_FALSE(update(mapper_, sweeps_).hasChanged());
  sweeps_[0].T_map_base.x = 0.08;
  EXPECT_EQ(update(mapper_, sweeps_).moved, 1U) << "it is as it was drawn that counts";
  expectAsDrawnAtOnce();
}

TEST_F(MapUpdateTest, ATurnCountsByWhatItDoesToTheFarthestBeam) {
  sweeps_[1].T_map_base.theta = 0.012;  // 4 m away: 0.048 m
  EXPECT_FALSE(update(mapper_, sweeps_).hasChanged());
  sweeps_[1].T_map_base.theta = 0.013;
  const UpdateReport report = update(mapper_, sweeps_);
  EXPECT_EQ(report.moved, 1U);
  EXPECT_EQ(report.drawn, 1U);
  EXPECT_FALSE(report.is_redrawn);
}

TEST_F(MapUpdateTest, WhatHasMovedIsTakenOutAndPutBack) {
  sweeps_[1].T_map_base.y = 7.0;
  update(mapper_, sweeps_);
  expectAsDrawnAtOnce();
}

TEST_F(MapUpdateTest, WhereMostHaveMovedAllIsDrawnAnew) {
  sweeps_[1].T_map_base.y = 7.0;
  sweeps_[2].T_map_base.y = 8.0;
  const UpdateReport report = update(mapper_, sweeps_);
  EXPECT_TRUE(report.is_redrawn);
  EXPECT_EQ(report.drawn, 3U);
  expectAsDrawnAtOnce();
}

TEST_F(MapUpdateTest, WhatIsGoneOrReplacedIsTakenOut) {
  sweeps_.erase(sweeps_.begin() + 1);
  const UpdateReport report = update(mapper_, sweeps_);
  EXPECT_EQ(report.removed, 1U);
  EXPECT_EQ(report.drawn, 0U);
  expectAsDrawnAtOnce();
  sweeps_[0] = placed(0, {});
  EXPECT_EQ(update(mapper_, sweeps_).drawn, 1U) << "another sweep of that number";
  update(mapper_, {});
  EXPECT_TRUE(mapper_.drawn().empty());
  EXPECT_TRUE(mapper_.render().cells.empty());
}

TEST_F(MapUpdateTest, WhatCantBeDrawnIsSaidAndLeavesTheMap) {
  sweeps_[1].T_map_base.x = std::numeric_limits<double>::quiet_NaN();
  const UpdateReport report = update(mapper_, sweeps_);
  ASSERT_EQ(report.refusals.size(), 1U);
  EXPECT_FALSE(report.refusals[0].empty());
  EXPECT_EQ(mapper_.drawn().size(), 2U);
  sweeps_.erase(sweeps_.begin() + 1);
  expectAsDrawnAtOnce();
}

}  // namespace
}  // namespace omega_slam::mapping
