#include "omega_slam/mapping/people_filter.h"

#include <gtest/gtest.h>

#include <memory>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "support/rooms.h"

namespace omega_slam::mapping {
namespace {

using sensing::BeamKind;
using SweepPtr = std::shared_ptr<const sensing::Sweep>;

constexpr double kResolution = 0.05;
constexpr std::int8_t kFree = grid::kFree;
constexpr std::int8_t kWall = grid::kOccupied;

/// A laser at the origin looks at a wall 4 m ahead; a person of 0.4 m may stand 2 m ahead.
SweepPtr sweepAt(bool is_person_there) {
  sensing::Sweep sweep;
  sweep.angle_increment = 0.005;
  for (int k = -100; k <= 100; ++k) {
    const double slope = std::tan(k * sweep.angle_increment);
    const bool meets = is_person_there && std::abs(2.0 * slope) < 0.2;
    const double x = meets ? 2.0 : 4.0;
    sweep.beams.push_back({{x + 0.01, x * slope}, BeamKind::kReturn});
  }
  return std::make_shared<const sensing::Sweep>(sweep);
}

/// Where the person stands.
std::int8_t valueThere(OccupancyMapper& mapper) {
  const grid::OccupancyGrid map = mapper.render();
  return map.at(map.geometry.cellAt({2.01, 0.01}));
}

class PeopleFilterTest : public ::testing::Test {
 protected:
  void see(bool is_person_there, int sweeps) {
    for (int k = 0; k < sweeps; ++k) {
      ASSERT_EQ(mapper_.put({next_++, sweepAt(is_person_there), {}}), "");
    }
  }
  OccupancyMapper mapper_;
  SweepId next_{0};
};

TEST_F(PeopleFilterTest, WhoStoodForLongAndLeftLosesHisWalls) {
  see(true, 40);
  EXPECT_EQ(valueThere(mapper_), kWall);
  see(false, 2);
  EXPECT_EQ(valueThere(mapper_), kWall);
  see(false, 1);
  EXPECT_EQ(valueThere(mapper_), kFree);
}

TEST_F(PeopleFilterTest, WithoutItTheShareOfHitsDecides) {
  OccupancyMapperConfig config;
  config.forget_people = false;
  OccupancyMapper plain(config);
  for (int k = 0; k < 40; ++k) {
    ASSERT_EQ(plain.add(*sweepAt(true), {}), "");
  }
  for (int k = 0; k < 5; ++k) {
    ASSERT_EQ(plain.add(*sweepAt(false), {}), "");
  }
  EXPECT_EQ(valueThere(plain), kWall);
}

TEST_F(PeopleFilterTest, WhoComesBackIsThereAgain) {
  see(true, 40);
  see(false, 3);
  see(true, 1);
  EXPECT_EQ(valueThere(mapper_), kWall);
}

TEST_F(PeopleFilterTest, TheOrderOfNumbersCountsAndNotOfCalls) {
  for (SweepId id = 3; id < 43; ++id) {
    ASSERT_EQ(mapper_.put({id, sweepAt(true), {}}), "");
  }
  for (SweepId id = 0; id < 3; ++id) {
    ASSERT_EQ(mapper_.put({id, sweepAt(false), {}}), "");
  }
  EXPECT_EQ(valueThere(mapper_), kWall) << "it was free before, not after";
}

TEST_F(PeopleFilterTest, TakingOutWhoSawThroughBringsTheWallBack) {
  see(true, 40);
  see(false, 3);
  mapper_.takeOut(41);
  EXPECT_EQ(valueThere(mapper_), kWall);
  ASSERT_EQ(mapper_.put({41, sweepAt(false), {}}), "");
  EXPECT_EQ(valueThere(mapper_), kFree);
}

TEST_F(PeopleFilterTest, TheWallBehindStays) {
  see(true, 5);
  see(false, 20);
  const grid::OccupancyGrid map = mapper_.render();
  for (double y = -1.5; y < 1.5; y += kResolution) {
    EXPECT_EQ(map.at(map.geometry.cellAt({4.01, y + 0.01})), kWall) << y;
  }
}

/// Close along a wall of a long room, there and back: beams run through the cells of the wall.
TEST(PeopleFilter, AWallPassedAtAGrazingAngleStays) {
  const Eigen::Vector2d half(10.0, 1.99);  // the wall runs near the far border of its cells
  OccupancyMapper with;
  OccupancyMapperConfig config;
  config.forget_people = false;
  OccupancyMapper without(config);
  for (double x = -9.0; x < 9.0; x += 0.5) {
    const geometry::Pose2 pose{x, -1.7, 0.1};
    const sensing::Sweep sweep = test::sweepInRoom(half, pose, {0.1, 0.0, 0.0}, 720);
    ASSERT_EQ(with.add(sweep, pose), "");
    ASSERT_EQ(without.add(sweep, pose), "");
  }
  EXPECT_EQ(with.render().cells, without.render().cells);
}

}  // namespace
}  // namespace omega_slam::mapping
