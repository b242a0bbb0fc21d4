#include "slam/log_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace omega_slam::experiments {
namespace {

constexpr std::size_t kScans = 4000;
constexpr double kPeriod = 0.2;  // [s]
constexpr std::uint64_t kSeed = 7;

/// A robot that drives straight on at 0.5 m/s and sees nothing.
Records blindDrive() {
  Records records;
  for (std::size_t k = 0; k < kScans; ++k) {
    io::ScanRecord record;
    record.scan.stamp = 100.0 + kPeriod * static_cast<double>(k);
    record.scan.angle_min = -1.5;
    record.scan.angle_increment = 0.03;
    record.scan.range_max = 10.0;
    record.scan.ranges.assign(101, std::nanf(""));
    record.scan.ranges[0] = static_cast<float>(k);  // a mark
    record.T_odom_base = {0.1 * static_cast<double>(k), 0.0, 0.0};
    records.push_back(record);
  }
  return records;
}

std::vector<float> marks(const Records& records) {
  std::vector<float> marks;
  for (const io::ScanRecord& record : records) {
    marks.push_back(record.scan.ranges[0]);
  }
  return marks;
}

TEST(LogFaults, AreTheSameForTheSameSeed) {
  const Records whole = blindDrive();
  for (const std::string& name : faultNames()) {
    EXPECT_EQ(marks(withFault(name, whole, kSeed)), marks(withFault(name, whole, kSeed))) << name;
    EXPECT_TRUE(withFault(name, {}, kSeed).empty()) << name;
  }
  EXPECT_NE(marks(withFault("missing_10", whole, 1)), marks(withFault("missing_10", whole, 2)));
  EXPECT_THROW((void)withFault("hail", whole, kSeed), std::invalid_argument);
}

TEST(LogFaults, NoneChangesNothing) {
  EXPECT_EQ(marks(withFault("none", blindDrive(), kSeed)), marks(blindDrive()));
}

TEST(LogFaults, ScansAreDoubledLostAndExchanged) {
  const Records whole = blindDrive();
  const auto size = [&](const char* name) {
    return static_cast<double>(withFault(name, whole, kSeed).size()) / kScans;
  };
  EXPECT_NEAR(size("duplicated_10"), 1.1, 0.02);
  EXPECT_NEAR(size("duplicated_30"), 1.3, 0.03);
  EXPECT_NEAR(size("missing_10"), 0.9, 0.02);
  EXPECT_NEAR(size("missing_30"), 0.7, 0.03);
  const auto exchanged = marks(withFault("reordered_30", whole, kSeed));
  EXPECT_EQ(exchanged.size(), kScans);
  EXPECT_FALSE(std::is_sorted(exchanged.begin(), exchanged.end()));
  EXPECT_EQ(std::set<float>(exchanged.begin(), exchanged.end()).size(), kScans) << "none is lost";
}

TEST(LogFaults, GapsLoseTimeAtThreePlaces) {
  const Records spoilt = withFault("gap_10", blindDrive(), kSeed);
  int gaps = 0;
  for (std::size_t k = 1; k < spoilt.size(); ++k) {
    const double wait = spoilt[k].scan.stamp - spoilt[k - 1].scan.stamp;
    gaps += wait > 2.0 * kPeriod ? 1 : 0;
    EXPECT_LT(wait, 10.0 + 2.0 * kPeriod);
  }
  EXPECT_EQ(gaps, 3);
}

TEST(LogFaults, AFrozenLaserRepeatsItselfWhileTheRobotDrives) {
  const Records spoilt = withFault("frozen_laser", blindDrive(), kSeed);
  std::size_t repeated = 0;
  for (std::size_t k = 1; k < spoilt.size(); ++k) {
    repeated += spoilt[k].scan.ranges[0] == spoilt[k - 1].scan.ranges[0] ? 1 : 0;
    EXPECT_GT(spoilt[k].T_odom_base.x, spoilt[k - 1].T_odom_base.x);
  }
  EXPECT_NEAR(static_cast<double>(repeated), 3.0 * 10.0 / kPeriod, 3.0);
}

TEST(LogFaults, HalfOfTheBeamsAreBlocked) {
  for (const io::ScanRecord& record : withFault("half_blocked", blindDrive(), kSeed)) {
    const auto& ranges = record.scan.ranges;
    ASSERT_EQ(std::count(ranges.begin(), ranges.end(), 0.15F), 50);
  }
}

TEST(LogFaults, APersonIsSeenAheadHalfOfTheTime) {
  const Records spoilt = withFault("person", blindDrive(), kSeed);
  std::size_t seen = 0;
  for (const io::ScanRecord& record : spoilt) {
    const auto& ranges = record.scan.ranges;
    const auto nearest = std::min_element(ranges.begin() + 1, ranges.end(),
                                          [](float a, float b) { return a < b || std::isnan(b); });
    if (!std::isnan(*nearest)) {
      ++seen;
      EXPECT_GT(*nearest, 1.0F);
      EXPECT_LT(*nearest, 1.5F);
    }
  }
  // 800 s: away in the second, fourth and sixth 120 s.
  EXPECT_NEAR(static_cast<double>(seen), (800.0 - 3.0 * 120.0) / kPeriod, 5.0);
}

TEST(LogFaults, OdometryBeginsAgain) {
  const Records spoilt = withFault("odometry_reset", blindDrive(), kSeed);
  EXPECT_DOUBLE_EQ(spoilt[kScans / 2 - 1].T_odom_base.x, 0.1 * (kScans / 2 - 1));
  EXPECT_DOUBLE_EQ(spoilt[kScans / 2].T_odom_base.x, 0.0);
  EXPECT_NEAR(spoilt.back().T_odom_base.x, 0.1 * (kScans / 2 - 1), 1e-9);
}

TEST(LogFaults, OdometryOverstatesWays) {
  const Records spoilt = withFault("odometry_scale", blindDrive(), kSeed);
  EXPECT_NEAR(spoilt.back().T_odom_base.x, 1.05 * 0.1 * (kScans - 1), 1e-6);
}

TEST(LogFaults, OdometryUnderstatesTurns) {
  Records log = blindDrive();
  log[1].T_odom_base.theta = 0.5;
  const Records spoilt = withFault("turn_scale", log, kSeed);
  EXPECT_NEAR(spoilt[1].T_odom_base.theta, 0.45, 1e-9);
  EXPECT_NEAR(spoilt[2].T_odom_base.theta, 0.0, 1e-9);
}

TEST(LogFaults, LaserLooksAskew) {
  const Records log = blindDrive();
  const Records spoilt = withFault("laser_askew", log, kSeed);
  for (std::size_t k = 0; k < log.size(); ++k) {
    EXPECT_NEAR(spoilt[k].mount.T_base_laser.theta - log[k].mount.T_base_laser.theta, 0.05, 1e-9);
  }
}

}  // namespace
}  // namespace omega_slam::experiments
