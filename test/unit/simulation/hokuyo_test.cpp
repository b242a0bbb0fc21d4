#include "omega_slam/simulation/hokuyo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

using geometry::kPi;

/// One scan of a laser that stands still.
sensing::LaserScan scanFrom(const World& world, const geometry::Pose2& T_world_laser,
                            const HokuyoConfig& config = {}, std::uint64_t seed = 1) {
  Hokuyo hokuyo(config, 5.0, seed);
  const auto scan = hokuyo.sweep(world, {5.0, T_world_laser}, {5.0999, T_world_laser});
  EXPECT_TRUE(scan);
  return scan.value_or(sensing::LaserScan{});
}

HokuyoConfig withoutNoise() {
  HokuyoConfig config;
  config.near_accuracy = config.far_accuracy = 0.0;
  return config;
}

TEST(Hokuyo, IsAUrg04LxUg01) {
  const sensing::LaserScan scan = scanFrom(*test::emptyRoom(2.0), {});
  EXPECT_EQ(scan.ranges.size(), 683U);
  EXPECT_NEAR(scan.angle_increment * 1024, 2.0 * kPi, 1e-12);
  EXPECT_NEAR(scan.angle_min, -341.0 / 1024.0 * 2.0 * kPi, 1e-12);
  EXPECT_NEAR(scan.time_increment, 0.1 / 1024.0, 1e-12);
  EXPECT_EQ(scan.stamp, 5.0);
  EXPECT_EQ(scan.range_min, 0.02);
  EXPECT_EQ(scan.range_max, 4.0);
}

TEST(Hokuyo, MeasuresExactlyWithoutNoise) {
  const auto room = test::emptyRoom(2.0);
  const geometry::Pose2 T_world_laser{0.3, -0.4, 0.5};
  const sensing::LaserScan scan = scanFrom(*room, T_world_laser, withoutNoise());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = 0.5 + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    // To the room's wall in closed form.
    const double x = (std::copysign(2.0, std::cos(angle)) - 0.3) / std::cos(angle);
    const double y = (std::copysign(2.0, std::sin(angle)) + 0.4) / std::sin(angle);
    EXPECT_NEAR(scan.ranges[i], std::min(x, y), 1e-6) << "beam " << i;
  }
}

TEST(Hokuyo, SaysNanWhereNothingReturns) {
  const sensing::LaserScan scan = scanFrom(*test::emptyRoom(10.0), {});
  EXPECT_THAT(scan.ranges, ::testing::Each(::testing::IsNan()));
}

TEST(Hokuyo, SaysInfinityWhereNothingReturnsIfAsked) {
  HokuyoConfig config;
  config.no_return_is_inf = true;
  const sensing::LaserScan scan = scanFrom(*test::emptyRoom(10.0), {}, config);
  EXPECT_THAT(scan.ranges, ::testing::Each(std::numeric_limits<float>::infinity()));
}

TEST(Hokuyo, SeesFartherIfTold) {
  HokuyoConfig config;
  config.range_max = 5.6;
  const auto room = test::emptyRoom(5.0);
  EXPECT_TRUE(std::isnan(scanFrom(*room, {}).ranges[341]));
  EXPECT_NEAR(scanFrom(*room, {}, config).ranges[341], 5.0, 0.15);
}

TEST(Hokuyo, NeverReportsARangeBeyondItsLimits) {
  // The wall is just within reach, so that noise alone carries readings beyond.
  const auto room = test::emptyRoom(3.95);
  int missing = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const float range : scanFrom(*room, {}, {}, seed).ranges) {
      missing += std::isnan(range) ? 1 : 0;
      EXPECT_FALSE(range > 4.0F);
    }
  }
  EXPECT_GT(missing, 0);
}

TEST(Hokuyo, NothingIsMeasuredBelowTheLeastRange) {
  const auto wall = test::drawnWorld({"#.", "#."}, 1.0);
  HokuyoConfig config = withoutNoise();
  EXPECT_TRUE(std::isnan(scanFrom(*wall, {1.01, 1.0, kPi}, config).ranges[341]));
  EXPECT_NEAR(scanFrom(*wall, {1.03, 1.0, kPi}, config).ranges[341], 0.03, 1e-6);
}

TEST(Hokuyo, LosesDarkSurfacesWithDistance) {
  const auto world = test::drawnWorld({"....d", "....d", "....d"}, 1.0);
  const HokuyoConfig config = withoutNoise();
  EXPECT_TRUE(std::isnan(scanFrom(*world, {2.49, 1.5, 0.0}, config).ranges[341]));
  EXPECT_NEAR(scanFrom(*world, {2.51, 1.5, 0.0}, config).ranges[341], 1.49, 1e-6);
}

TEST(Hokuyo, DoesNotSeeGlass) {
  const auto world = test::drawnWorld({".g.#", ".g.#", ".g.#"}, 1.0);
  EXPECT_NEAR(scanFrom(*world, {0.5, 1.5, 0.0}, withoutNoise()).ranges[341], 2.5, 1e-6);
}

TEST(Hokuyo, ScansFollowEachOtherAtTheirRate) {
  const auto room = test::emptyRoom(2.0);
  Hokuyo hokuyo({}, 1.0, 1);
  std::vector<double> stamps;
  for (int i = 0; i < 500; ++i) {
    const double now = 1.0 + i * 0.02;
    if (const auto scan = hokuyo.sweep(*room, {now, {}}, {1.0 + (i + 1) * 0.02, {}})) {
      EXPECT_EQ(scan->ranges.size(), 683U);
      EXPECT_LT(scan->stamp + 682 * scan->time_increment, now + 0.02);
      stamps.push_back(scan->stamp);
    }
  }
  ASSERT_EQ(stamps.size(), 100U);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    EXPECT_NEAR(stamps[i], 1.0 + 0.1 * static_cast<double>(i), 1e-9);
  }
}

TEST(Hokuyo, EveryBeamIsCastFromWhereTheLaserThenIs) {
  const auto room = test::emptyRoom(2.5);
  const double turn_rate = 1.5;
  const double speed = 0.6;
  const auto pose = [&](double t) { return geometry::Pose2{speed * t, 0.0, turn_rate * t}; };
  Hokuyo hokuyo(withoutNoise(), 0.0, 1);
  std::optional<sensing::LaserScan> scan;
  for (int i = 0; i < 5 && !scan; ++i) {
    scan = hokuyo.sweep(*room, {i * 0.02, pose(i * 0.02)}, {(i + 1) * 0.02, pose((i + 1) * 0.02)});
  }
  ASSERT_TRUE(scan);
  for (std::size_t i = 0; i < scan->ranges.size(); i += 11) {
    const auto beam = static_cast<double>(i);
    const geometry::Pose2 T_world_laser = pose(beam * scan->time_increment);
    const auto hit =
        room->castRay(T_world_laser.translation(),
                      T_world_laser.theta + scan->angle_min + beam * scan->angle_increment, 4.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(scan->ranges[i], hit->range, 1e-6) << "beam " << i;
  }
}

TEST(HokuyoConfiguration, NamesEveryViolation) {
  HokuyoConfig config;
  EXPECT_TRUE(config.validate().empty());
  config.rate = 0.0;
  config.beams = 0;
  config.range_max = 0.01;
  config.accuracy_in_deviations = 0.5;
  EXPECT_THAT(config.validate(),
              ::testing::ElementsAre(::testing::HasSubstr("rate"), ::testing::HasSubstr("beams"),
                                     ::testing::HasSubstr("range_max"),
                                     ::testing::HasSubstr("accuracy_in")));
  EXPECT_THROW(Hokuyo(config, 0.0, 1), std::invalid_argument);
  HokuyoConfig too_wide;
  too_wide.beams = 1025;
  EXPECT_THAT(too_wide.validate(),
              ::testing::ElementsAre(::testing::HasSubstr("beams * angle_increment")));
}

}  // namespace
}  // namespace omega_slam::simulation
