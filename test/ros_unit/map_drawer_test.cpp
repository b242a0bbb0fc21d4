#include "nodes/common/map_drawer.h"

#include <gtest/gtest.h>

#include <memory>

namespace omega_slam {
namespace {

using geometry::Pose2;

/// A keyframe with one beam of 4 m straight ahead.
PlacedKeyframe placed(graph::NodeId id, const Pose2& T_map_base) {
  slam::Keyframe keyframe;
  keyframe.id = id;
  keyframe.sweep.angle_increment = 0.01;
  keyframe.sweep.beams = {{{4.0, 0.0}, sensing::BeamKind::kReturn}};
  return {std::make_shared<const slam::Keyframe>(keyframe), T_map_base};
}

mapping::OccupancyMapperConfig config() {
  mapping::OccupancyMapperConfig result;
  result.resolution = 0.1;
  return result;
}

TEST(MapDrawer, OnlyNewKeyframesAreDrawnWhilePosesStand) {
  MapDrawer drawer(config());
  std::vector<PlacedKeyframe> keyframes{placed(0, {}), placed(1, {0.0, 1.0, 0.0})};
  EXPECT_EQ(drawer.update(keyframes).drawn, 2U);
  keyframes[0].T_map_base.x = 0.04;  // less than half a cell
  keyframes.push_back(placed(2, {0.0, 2.0, 0.0}));
  const DrawReport report = drawer.update(keyframes);
  EXPECT_EQ(report.drawn, 1U);
  EXPECT_FALSE(report.is_redrawn);
  EXPECT_EQ(drawer.drawn(), 3U);
}

TEST(MapDrawer, SmallStepsAddUpToARedraw) {
  MapDrawer drawer(config());
  std::vector<PlacedKeyframe> keyframes{placed(0, {})};
  drawer.update(keyframes);
  keyframes[0].T_map_base.x = 0.04;
  EXPECT_FALSE(drawer.update(keyframes).is_redrawn);
  keyframes[0].T_map_base.x = 0.08;
  EXPECT_TRUE(drawer.update(keyframes).is_redrawn) << "it is as it was drawn that counts";
}

TEST(MapDrawer, ATurnCountsByWhatItDoesToTheFarthestBeam) {
  MapDrawer drawer(config());
  std::vector<PlacedKeyframe> keyframes{placed(0, {})};
  drawer.update(keyframes);
  keyframes[0].T_map_base.theta = 0.012;  // 4 m away: 0.048 m
  EXPECT_FALSE(drawer.update(keyframes).is_redrawn);
  keyframes[0].T_map_base.theta = 0.013;
  const DrawReport report = drawer.update(keyframes);
  EXPECT_TRUE(report.is_redrawn);
  EXPECT_EQ(report.drawn, 1U);
}

TEST(MapDrawer, ARedrawGivesTheMapOfTheNewPosesAlone) {
  MapDrawer drawer(config());
  std::vector<PlacedKeyframe> keyframes{placed(0, {}), placed(1, {0.0, 1.0, 0.0})};
  drawer.update(keyframes);
  keyframes[1].T_map_base.y = 3.0;
  drawer.update(keyframes);
  MapDrawer fresh(config());
  fresh.update(keyframes);
  EXPECT_EQ(drawer.render().cells, fresh.render().cells);
  EXPECT_EQ(drawer.render().geometry.origin, fresh.render().geometry.origin);
}

TEST(MapDrawer, KeyframesThatAreGoneOrReplacedAreTakenOut) {
  MapDrawer drawer(config());
  const std::vector<PlacedKeyframe> keyframes{placed(0, {}), placed(1, {0.0, 1.0, 0.0})};
  drawer.update(keyframes);
  EXPECT_TRUE(drawer.update({keyframes[0]}).is_redrawn);
  EXPECT_EQ(drawer.drawn(), 1U);
  EXPECT_TRUE(drawer.update({placed(0, {})}).is_redrawn) << "another keyframe of that number";
  drawer.update({});
  EXPECT_EQ(drawer.drawn(), 0U);
  EXPECT_TRUE(drawer.render().cells.empty());
}

TEST(MapDrawer, WhatCantBeDrawnIsSaid) {
  MapDrawer drawer(config());
  const DrawReport report = drawer.update({placed(0, {}), placed(1, {1e9, 0.0, 0.0})});
  EXPECT_EQ(report.drawn, 1U);
  ASSERT_EQ(report.refusals.size(), 1U);
  EXPECT_FALSE(report.refusals[0].empty());
}

}  // namespace
}  // namespace omega_slam
