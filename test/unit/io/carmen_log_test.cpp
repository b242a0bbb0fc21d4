#include "omega_slam/io/carmen_log.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::io {
namespace {

using geometry::kPi;

std::string flaser(int beams, const std::string& range, const std::string& stamp = "5.5") {
  std::string line = "FLASER " + std::to_string(beams);
  for (int beam = 0; beam < beams; ++beam) {
    line += " " + range;
  }
  return line + " 9 9 9 1.5 -2.5 0.25 " + stamp + " host 5.6\n";
}

TEST(CarmenLog, ReadsAFlaserMessage) {
  const CarmenLog log = parseCarmenLog(
      "# comment\nPARAM robot_x 1\nFLASER 3 1.25 2 49.9 7 8 9 1.5 -2.5 0.25 976052857.337530 host "
      "0.5\n",
      "log");
  ASSERT_EQ(log.records.size(), 1U);
  const CarmenRecord& record = log.records[0];
  EXPECT_DOUBLE_EQ(record.scan.stamp, 976052857.337530);
  EXPECT_EQ(record.T_odom_base.vector(), Eigen::Vector3d(1.5, -2.5, 0.25));  // the second pose
  ASSERT_EQ(record.scan.ranges.size(), 3U);
  EXPECT_FLOAT_EQ(record.scan.ranges[0], 1.25F);
  EXPECT_FLOAT_EQ(record.scan.ranges[1], 2.0F);
  EXPECT_TRUE(std::isinf(record.scan.ranges[2]));
  EXPECT_DOUBLE_EQ(record.scan.range_max, 49.9);
  EXPECT_DOUBLE_EQ(record.scan.time_increment, 0.0);
}

TEST(CarmenLog, BeamsSpanHalfATurn) {
  const auto increment = [](int beams) {
    return parseCarmenLog(flaser(beams, "1"), "log").records.at(0).scan.angle_increment;
  };
  EXPECT_DOUBLE_EQ(increment(180), kPi / 180);
  EXPECT_DOUBLE_EQ(increment(181), kPi / 180);
  EXPECT_DOUBLE_EQ(increment(360), kPi / 360);
  EXPECT_DOUBLE_EQ(increment(361), kPi / 360);
  EXPECT_DOUBLE_EQ(parseCarmenLog(flaser(361, "1"), "log").records[0].scan.angle_min, -kPi / 2);
}

TEST(CarmenLog, NoReturnIsInfiniteWhateverTheMark) {
  for (const char* mark : {"49.9", "50", "79.99", "81.83", "81.91", "inf"}) {
    const CarmenLog log = parseCarmenLog(flaser(2, mark), "log");
    EXPECT_EQ(log.records[0].scan.ranges[1], std::numeric_limits<float>::infinity()) << mark;
  }
  EXPECT_FLOAT_EQ(parseCarmenLog(flaser(2, "49.89"), "log").records[0].scan.ranges[1], 49.89F);
  CarmenLogOptions options;
  options.no_return_range = 8.0;
  EXPECT_TRUE(std::isinf(parseCarmenLog(flaser(2, "8"), "log", options).records[0].scan.ranges[1]));
}

TEST(CarmenLog, RangesThatAreNoneAreNaN) {
  for (const char* mark : {"0", "-1", "nan", "-nan", "1.5x", "-inf", "?"}) {
    const CarmenLog log = parseCarmenLog(flaser(2, mark), "log");
    ASSERT_EQ(log.records.size(), 1U) << mark;
    EXPECT_TRUE(std::isnan(log.records[0].scan.ranges[0])) << mark;
  }
}

TEST(CarmenLog, KeepsTheOrderOfTheFileAndCountsBackwardStamps) {
  const CarmenLog log =
      parseCarmenLog(flaser(2, "1", "3") + flaser(2, "1", "1") + flaser(2, "1", "2"), "log");
  ASSERT_EQ(log.records.size(), 3U);
  EXPECT_EQ(log.records[1].scan.stamp, 1.0);
  EXPECT_EQ(log.backward_stamps, 1U);
  EXPECT_EQ(log.malformed_lines, 0U);
}

TEST(CarmenLog, ReadsRobotLaserWhereThereIsNoFlaser) {
  const std::string robot_laser =
      "ROBOTLASER1 0 -2.0 4.0 0.5 20 0.01 0 3 1.5 20 25 1 77 0.1 0 0 3 4 0.5 0 0 1 1 0 12.5 h 1\n";
  const CarmenLog log = parseCarmenLog(robot_laser, "log");
  ASSERT_EQ(log.records.size(), 1U);
  const CarmenRecord& record = log.records[0];
  EXPECT_EQ(record.T_odom_base.vector(), Eigen::Vector3d(3, 4, 0.5));
  EXPECT_DOUBLE_EQ(record.scan.angle_min, -2.0);
  EXPECT_DOUBLE_EQ(record.scan.angle_increment, 0.5);
  EXPECT_DOUBLE_EQ(record.scan.stamp, 12.5);
  EXPECT_FLOAT_EQ(record.scan.ranges[0], 1.5F);
  EXPECT_TRUE(std::isinf(record.scan.ranges[1]));  // its own maximal range is 20 m
  EXPECT_EQ(parseCarmenLog(robot_laser + flaser(2, "1"), "log").records[0].scan.ranges.size(), 2U);
}

TEST(CarmenLog, WindowsLineEndingsAndNoFinalOne) {
  EXPECT_EQ(parseCarmenLog("FLASER 1 1.0 0 0 0 1 2 3 4.0 h 5\r\nFLASER 1 1 0 0 0 1 2 3 4", "log")
                .records.size(),
            2U);
}

}  // namespace
}  // namespace omega_slam::io
