// Scans and odometry meet at the right time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ros_unit/bag_fixture.h"

namespace omega_slam {
namespace {

using geometry::Pose2;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

class BagLogTest : public test::BagFixture {};

TEST_F(BagLogTest, OdometryIsThatOfTheScansStamp) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.25);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].T_odom_base.x, 1.25, 1e-6);
  EXPECT_EQ(records[0].motion_during_sweep.x, 0.0);
  EXPECT_EQ(records[0].scan.ranges.size(), 11U);
  EXPECT_NEAR(records[0].mount.T_base_laser.x, 0.2, 1e-9);
  EXPECT_NEAR(records[0].mount.T_base_laser.theta, 0.5, 1e-9);
  EXPECT_FALSE(records[0].mount.upside_down);
}

TEST_F(BagLogTest, MotionDuringTheSweepReachesFromTheFirstBeamToTheLast) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.0, 0.02);  // eleven beams, so ten steps
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].motion_during_sweep.x, 0.2, 1e-6);
}

TEST_F(BagLogTest, SweepBeyondTheLastOdometryGoesOnAsItWent) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.9, 0.02);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].motion_during_sweep.x, 0.2, 1e-6);
}

TEST_F(BagLogTest, ScanRecordedBeforeItsOdometryWaitsForIt) {
  mountLaser();
  writer_.scanRecordedAt(100.5, 100.55);
  writer_.scanRecordedAt(100.6, 100.65);
  for (int i = 0; i < 20; ++i) {
    const double stamp = 100.0 + 0.1 * i;
    writer_.odometryRecordedAt(stamp + 1.0, stamp, {0.1 * i, 0.0, 0.0});
  }
  const auto records = readAll();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_NEAR(records[0].T_odom_base.x, 0.55, 1e-6);
  EXPECT_NEAR(records[1].T_odom_base.x, 0.65, 1e-6);
}

TEST_F(BagLogTest, ScansOutsideOfTheOdometryAreDroppedAndCounted) {
  mountLaser();
  writer_.scan(99.0);
  drive(100.0, 102.0);
  writer_.scan(101.0);
  writer_.scan(103.0);
  EXPECT_EQ(readAll().size(), 1U);
  EXPECT_EQ(report_.scans, 3U);
  EXPECT_EQ(report_.records, 1U);
  EXPECT_THAT(report_.dropped_scans, ElementsAre(Pair("after the odometry ends", 1),
                                                 Pair("before the odometry begins", 1)));
}

TEST_F(BagLogTest, ScanFromTheFutureDoesNotHoldTheOthers) {
  mountLaser();
  writer_.scanRecordedAt(100.0, 5000.0);
  drive(100.0, 102.0);
  writer_.scan(101.0);
  EXPECT_EQ(readAll().size(), 1U);
  EXPECT_THAT(report_.dropped_scans, ElementsAre(Pair("after the odometry ends", 1)));
}

TEST_F(BagLogTest, ScanOfAnotherLaserIsDroppedAndCounted) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.0);
  writer_.scan(101.1, 0.0, "rear_laser");
  EXPECT_EQ(readAll().size(), 1U);
  EXPECT_THAT(report_.dropped_scans, ElementsAre(Pair("another laser's frame", 1)));
}

TEST_F(BagLogTest, FaultyOdometryIsDroppedAndCounted) {
  mountLaser();
  drive(100.0, 101.0);
  writer_.odometryRecordedAt(101.01, 101.01, {std::nan(""), 0.0, 0.0});
  writer_.odometryRecordedAt(101.02, 101.0, {0.0, 0.0, 0.0});
  writer_.odometryRecordedAt(101.03, 100.5, {0.0, 0.0, 0.0});
  writer_.scan(101.05);
  drive(101.1, 102.0);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].T_odom_base.x, 1.05, 1e-6);
  EXPECT_THAT(report_.dropped_odometry, ElementsAre(Pair("not a rigid motion of finite numbers", 1),
                                                    Pair("older than the one before", 1),
                                                    Pair("same stamp as the one before", 1)));
}

TEST_F(BagLogTest, ClockThatJumpsBackStartsAnew) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.0);
  writer_.scan(102.5);
  for (int i = 0; i < 20; ++i) {
    writer_.odometryRecordedAt(103.0 + 0.1 * i, 50.0 + 0.1 * i, {7.0, 0.0, 0.0});
  }
  writer_.scanRecordedAt(104.0, 51.0);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[1].scan.stamp, 51.0);
  EXPECT_EQ(records[1].T_odom_base.x, 7.0);
  EXPECT_THAT(report_.dropped_scans, ElementsAre(Pair("the clock jumped back", 1)));
}

TEST_F(BagLogTest, TfServesWhereNoOdometryIsPublished) {
  mountLaser();
  for (int i = 0; i <= 20; ++i) {
    writer_.transform(100.0 + 0.1 * i, "odom", "base_link", {0.1 * i, 0.0, 0.0});
  }
  writer_.scan(101.25);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].T_odom_base.x, 1.25, 1e-6);
  EXPECT_EQ(report_.odometry, "tf odom -> base_link");
  EXPECT_THAT(report_.dropped_odometry, IsEmpty());
}

TEST_F(BagLogTest, TfMayBeAskedForThoughOdometryIsPublished) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.transform(100.0, "odom", "base_link", {7.0, 0.0, 0.0});
  writer_.transform(102.0, "odom", "base_link", {7.0, 0.0, 0.0});
  writer_.scan(101.0);
  BagLogOptions options;
  options.odometry_topic = "tf";
  const auto records = readAll(options);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].T_odom_base.x, 7.0);
}

TEST_F(BagLogTest, TfThatJumpsBackStartsAnew) {
  mountLaser();
  writer_.transform(100.0, "base_link", "laser", {0.2, 0.0, 0.0}, "/tf_static");
  for (int i = 0; i < 20; ++i) {
    writer_.transform(100.0 + 0.1 * i, "odom", "base_link", {0.1 * i, 0.0, 0.0});
  }
  for (int i = 0; i < 20; ++i) {
    writer_.transformRecordedAt(103.0 + 0.1 * i, 50.0 + 0.1 * i, "odom", "base_link",
                                {7.0, 0.0, 0.0});
  }
  writer_.scanRecordedAt(104.0, 51.0);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].T_odom_base.x, 7.0);
}

TEST_F(BagLogTest, ProgressGrowsToOne) {
  mountLaser();
  drive(100.0, 102.0);
  for (int i = 0; i < 10; ++i) {
    writer_.scan(100.05 + 0.1 * i);
  }
  writer_.close();
  BagLog log(path_, BagLogOptions{});
  double before = log.progress();
  EXPECT_EQ(before, 0.0);
  while (log.next()) {
    EXPECT_GE(log.progress(), before);
    before = log.progress();
  }
  EXPECT_EQ(log.progress(), 1.0);
}

}  // namespace
}  // namespace omega_slam
