#include "omega_slam/io/rover_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::io {
namespace {

using geometry::kPi;

std::string line(const std::string& stamp, int left, int right, const std::string& range = "1500") {
  std::string text = stamp + " 9 " + std::to_string(left) + ' ' + std::to_string(right);
  for (int k = 0; k < 21; ++k) {
    text += " -8.5";
  }
  for (int k = 0; k < 682; ++k) {
    text += ' ' + range;
  }
  return text + " \n";
}

TEST(RoverLog, ReadsAScan) {
  const RoverLog log = parseRoverLog(line("212387282", 5, 7), "log");
  ASSERT_EQ(log.records.size(), 1U);
  const ScanRecord& record = log.records[0];
  EXPECT_DOUBLE_EQ(record.scan.stamp, 212.387282);
  ASSERT_EQ(record.scan.ranges.size(), 682U);
  EXPECT_FLOAT_EQ(record.scan.ranges[681], 1.5F);
  EXPECT_NEAR(record.scan.angle_min + 340 * record.scan.angle_increment, 0.0, 1e-12)
      << "the beam straight ahead";
  EXPECT_NEAR(geometry::radiansToDegrees(record.scan.angle_min), -119.53, 0.01);
  EXPECT_EQ(record.T_odom_base.vector(), Eigen::Vector3d::Zero()) << "whatever the ticks";
  EXPECT_EQ(record.mount.T_base_laser.x, 0.145);
}

TEST(RoverLog, ZeroIsNoReturnAndSmallRangesAreErrors) {
  const auto rangeFor = [](const char* text) {
    return parseRoverLog(line("1", 0, 0, text), "log").records[0].scan.ranges[0];
  };
  EXPECT_EQ(rangeFor("0"), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(rangeFor("7")));
  EXPECT_TRUE(std::isnan(rangeFor("19")));
  EXPECT_FLOAT_EQ(rangeFor("20"), 0.02F);
}

TEST(RoverLog, BothWheelsAheadDriveStraightOn) {
  const RoverLog log = parseRoverLog(line("1", 100, 50) + line("2", 2100, 2050), "log");
  const geometry::Pose2& pose = log.records[1].T_odom_base;
  EXPECT_NEAR(pose.x, 2.0 * kPi * 0.077, 1e-9) << "a turn of the wheels";
  EXPECT_NEAR(pose.y, 0.0, 1e-12);
  EXPECT_NEAR(pose.theta, 0.0, 1e-12);
}

TEST(RoverLog, OneWheelAloneDrivesAQuarterCircle) {
  const double ticks = 2.0 * 0.165 * kPi / 2.0 / (2.0 * kPi * 0.077) * 2000.0;
  const RoverLog log =
      parseRoverLog(line("1", 0, 0) + line("2", 0, static_cast<int>(std::lround(ticks))), "log");
  const geometry::Pose2& pose = log.records[1].T_odom_base;
  EXPECT_NEAR(pose.theta, kPi / 2.0, 1e-3);
  EXPECT_NEAR(pose.x, 0.165, 1e-3);
  EXPECT_NEAR(pose.y, 0.165, 1e-3);
}

TEST(RoverLog, MalformedLinesArePassedOver) {
  const std::string good = line("1", 0, 0);
  for (const std::string& bad : {std::string("1 2 3\n"), "x" + good, line("1", 0, 0, "1 1"),
                                 line("nan", 0, 0), line("1", 0, 0, "1e999")}) {
    const RoverLog log = parseRoverLog(good + bad + "\n" + good, "log");
    EXPECT_EQ(log.records.size(), 2U);
    EXPECT_EQ(log.malformed_lines, 1U);
    EXPECT_THAT(log.first_fault, ::testing::StartsWith("line 2: "));
  }
}

TEST(RoverLog, WithoutAUsableLineThereIsNone) {
  EXPECT_THROW((void)parseRoverLog("", "log"), std::runtime_error);
  try {
    (void)parseRoverLog("1 2 3\n", "log");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "log: no usable line is in it; the first fault is in line 1: 3 numbers where 707 "
                 "are expected.");
  }
}

}  // namespace
}  // namespace omega_slam::io
