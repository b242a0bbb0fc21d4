// Real bags, as they were recorded by others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/common/bag_log.h"
#include "support/paths.h"

namespace omega_slam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct RealBag {
  const char* name;
  std::optional<geometry::Pose2> laser_pose;
  const char* scan_topic;
  const char* odometry;
  const char* base_frame;
  std::size_t scans;
  std::map<std::string, std::size_t> dropped;
};

std::ostream& operator<<(std::ostream& os, const RealBag& bag) { return os << bag.name; }

const RealBag kRealBags[] = {{"intel_2726", {}, "/scan", "/odom", "base_link", 2664, {}},
                             {"mit-csail", {}, "/scan", "/odom", "base_link", 1988, {}},
                             {"hrp_mylaserdata3",
                              geometry::Pose2{0.1, 0.0, 0.0},
                              "/scan",
                              "/odom",
                              "base_link",
                              102,
                              {{"before the odometry begins", 1}}},
                             {"hrp_mylaserdata2",
                              geometry::Pose2{},
                              "/scan",
                              "tf odom -> base_link",
                              "base_link",
                              232,
                              {{"before the odometry begins", 1}}},
                             {"basic_localization_stage",
                              {},
                              "/base_scan",
                              "tf odom -> base_footprint",
                              "base_footprint",
                              24,
                              {}}};

class RealBagLog : public testing::TestWithParam<RealBag> {};

TEST_P(RealBagLog, HandsOutEveryScanThatTheOdometryCovers) {
  const std::string file = std::string("bags/") + GetParam().name + ".bag";
  const auto path = test::dataFile(file);
  if (!path) {
    GTEST_SKIP() << test::missingData(file);
  }
  BagLogOptions options;
  options.laser_pose = GetParam().laser_pose;
  BagLog log(path->string(), options);
  std::size_t records = 0;
  double stamp = 0.0;
  while (const auto record = log.next()) {
    ++records;
    EXPECT_GE(record->scan.stamp, stamp);
    stamp = record->scan.stamp;
    EXPECT_TRUE(record->T_odom_base.isFinite());
  }
  EXPECT_EQ(log.progress(), 1.0);
  EXPECT_EQ(log.report().scan_topic, GetParam().scan_topic);
  EXPECT_EQ(log.report().odometry, GetParam().odometry);
  EXPECT_EQ(log.report().base_frame, GetParam().base_frame);
  EXPECT_EQ(log.report().scans, GetParam().scans);
  EXPECT_EQ(records, log.report().records);
  std::size_t dropped = 0;
  for (const auto& [cause, count] : log.report().dropped_scans) {
    dropped += count;
  }
  EXPECT_EQ(records + dropped, GetParam().scans);
  // The laser was there a moment before the odometry.
  EXPECT_EQ(log.report().dropped_scans, GetParam().dropped);
  EXPECT_THAT(log.report().dropped_odometry, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Bags, RealBagLog, testing::ValuesIn(kRealBags), [](const auto& instance) {
  std::string name = instance.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

std::string refusalOf(const std::string& file) {
  try {
    const BagLog log(test::dataFile(file)->string(), BagLogOptions{});
  } catch (const BagError& error) {
    return error.what();
  }
  return "";
}

TEST(RealBagLog, SaysThatTheLaserTransformIsMissing) {
  const std::string file = "bags/hrp_mylaserdata3.bag";
  if (!test::dataFile(file)) {
    GTEST_SKIP() << test::missingData(file);
  }
  EXPECT_THAT(refusalOf(file), HasSubstr("no transform from the laser's frame 'laser' to the "
                                         "robot's base 'base_link'; say where the laser sits with "
                                         "--laser-pose X Y YAW."));
}

TEST(RealBagLog, SaysThatThereIsNoOdometry) {
  const std::string file = "bags/scan_tools_hokuyo_handheld.bag";
  if (!test::dataFile(file)) {
    GTEST_SKIP() << test::missingData(file);
  }
  EXPECT_THAT(refusalOf(file), HasSubstr("there is no odometry, neither nav_msgs/Odometry nor tf. "
                                         "It holds: /scan (sensor_msgs/LaserScan)."));
}

}  // namespace
}  // namespace omega_slam
