#include "omega_slam/matching/sight_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

View viewFrom(const test::Room& room, const Pose2& T_room_laser) {
  std::mt19937_64 random(1);
  const View own{test::measurePoints(room, T_room_laser, 720, 0.01, random), {0.0, 0.0}};
  return transformed(T_room_laser, own);
}

TEST(SightCheck, TwoViewsOfOneRoomDoNotContradict) {
  const test::Room room = test::furnishedRoom();
  const auto check =
      checkSightBothWays(viewFrom(room, {-1.0, -1.0, 0.3}), viewFrom(room, {1.0, 0.8, -2.0}));
  EXPECT_GT(check.compared, 300U);
  EXPECT_LT(check.contradiction(), 0.05);
}

TEST(SightCheck, AWallThatIsSeenThroughIsCounted) {
  const test::Room room = test::furnishedRoom();
  test::Room divided = room;
  divided.walls.push_back({{0.8, -3.0}, {0.8, 3.0}});
  const View before = viewFrom(room, {-1.0, -1.2, 0.0});
  const View after = viewFrom(divided, {-1.0, -1.2, 0.0});
  EXPECT_GT(checkSight(before, after).seen_through, 50U);
  EXPECT_EQ(checkSight(after, before).seen_through, 0U) << "what is behind a wall is hidden";
  EXPECT_GT(checkSightBothWays(before, after).contradiction(), 0.1);
}

TEST(SightCheck, WhereNothingCanBeComparedNothingIsSaid) {
  EXPECT_EQ(checkSightBothWays({}, {}).contradiction(), 0.0);
  const View one{{{1.0, 0.0}}, {0.0, 0.0}};
  EXPECT_EQ(checkSightBothWays(one, {}).compared, 0U);
}

}  // namespace
}  // namespace omega_slam::matching
