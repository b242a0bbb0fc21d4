#include "omega_slam/config/slam_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace omega_slam::config {
namespace {

using testing::HasSubstr;

template <class Config>
std::string faultsOf(const std::string& yaml) {
  Config config;
  ParameterReader reader(YAML::Load(yaml), "node");
  read(reader, config);
  try {
    reader.finish();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(SlamConfig, ValuesReachTheirFields) {
  ScanMatcherNodeConfig config;
  ParameterReader reader(
      YAML::Load("{keyframe_translation: 0.75, icp: {max_iterations: 7}, laser_pose: [0.1, 0, 3],"
                 " match: {range_noise: 0.07}, loops: {neighbours: 5}, scans: {max_range: 5.6}}"),
      "scan_matcher");
  read(reader, config);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(config.front_end.keyframe_translation, 0.75);
  EXPECT_EQ(config.front_end.matching.icp.max_iterations, 7);
  EXPECT_EQ(config.front_end.matching.match.range_noise, 0.07);
  EXPECT_EQ(config.loops.place.match.range_noise, 0.07);
  EXPECT_EQ(config.loops.neighbours, 5);
  EXPECT_EQ(config.intake.max_range, 5.6);
  EXPECT_EQ(config.laser_pose, (std::vector<double>{0.1, 0.0, 3.0}));
}

TEST(SlamConfig, FaultsBetweenKeysCarryTheFullName) {
  EXPECT_THAT(faultsOf<ScanMatcherNodeConfig>("scans: {min_range: 3.0, max_range: 2.0}"),
              HasSubstr("`node/scans/max_range` is 2"));
}

TEST(SlamConfig, FramesHaveNamesWithoutALeadingSlash) {
  const std::string sentence = " must be the name of a frame, without a leading '/'.";
  EXPECT_EQ(faultsOf<GraphSlamNodeConfig>("map_frame: /map"), "`node/map_frame`" + sentence);
  EXPECT_EQ(faultsOf<GraphSlamNodeConfig>("odom_frame: \"\""), "`node/odom_frame`" + sentence);
  EXPECT_EQ(faultsOf<MapBuilderNodeConfig>("map_frame: /map"), "`node/map_frame`" + sentence);
  EXPECT_EQ(faultsOf<MotionModelNodeConfig>("base_frame: /base"), "`node/base_frame`" + sentence);
}

TEST(SlamConfig, LaserPoseIsThreeNumbersOrNone) {
  EXPECT_EQ(faultsOf<ScanMatcherNodeConfig>("laser_pose: []"), "");
  EXPECT_EQ(faultsOf<ScanMatcherNodeConfig>("laser_pose: [1, 2]"),
            "`node/laser_pose` must be empty, or x, y and yaw.");
}

TEST(SlamConfig, SaveStemIsNotEmpty) {
  EXPECT_EQ(faultsOf<MapBuilderNodeConfig>("save_stem: \"\""),
            "`node/save_stem` must not be empty.");
}

TEST(SlamConfig, MapsAreSavedInAnyFormatThatCanHoldThem) {
  MapBuilderNodeConfig config;
  ParameterReader reader(YAML::Load("{save_mode: scale, save_image: png}"), "map_builder");
  read(reader, config);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(config.save_format.mode, grid::MapMode::kScale);
  EXPECT_EQ(config.save_format.image, grid::ImageKind::kPng);
  EXPECT_THAT(faultsOf<MapBuilderNodeConfig>("save_mode: scale"),
              HasSubstr("`node/save_image` can't be pgm: the mode scale"));
}

}  // namespace
}  // namespace omega_slam::config
