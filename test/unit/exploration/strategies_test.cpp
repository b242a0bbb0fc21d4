#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "omega_slam/exploration/information_gain.h"
#include "omega_slam/exploration/strategy_factory.h"
#include "omega_slam/exploration/tour.h"
#include "omega_slam/exploration/wall_follower.h"
#include "omega_slam/geometry/angle.h"
#include "support/drawn_map.h"

namespace omega_slam::exploration {
namespace {

using ::testing::ElementsAre;

Option option(FrontierId id, double x, double y, double travel, double gain, double turn) {
  return {id, {{x, y, 0.0}, travel}, gain, turn};
}

/// Frontier 1 is near, 2 near the origin, 3 straight ahead, 4 rich.
Situation situation() {
  Situation result;
  result.options = {option(4, 9.0, 4.0, 6.0, 30.0, 2.0), option(1, 6.0, 1.0, 1.0, 1.0, 1.6),
                    option(3, 8.0, 0.0, 3.0, 2.0, 0.1), option(2, 0.5, 0.0, 4.5, 2.0, 3.1)};
  result.T_map_base = {5.0, 0.0, 0.0};
  result.travelFrom = [options = result.options](std::size_t from) {
    std::vector<double> lengths;
    for (const Option& to : options) {
      lengths.push_back(
          geometry::distance(options[from].viewpoint.T_map_base, to.viewpoint.T_map_base));
    }
    return lengths;
  };
  result.travelHome = [count = result.options.size()] { return std::vector<double>(count, 0.0); };
  return result;
}

FrontierId chosenBy(const std::string& strategy) {
  const Situation now = situation();
  return now.options[makeStrategy(strategy)->choose(now)].frontier;
}

TEST(Strategies, EachChoosesItsOwn) {
  EXPECT_EQ(chosenBy("nearest_to_robot"), 1U);
  EXPECT_EQ(chosenBy("nearest_to_origin"), 2U);
  EXPECT_EQ(chosenBy("along_route"), 3U);
  EXPECT_EQ(chosenBy("gain_over_cost"), 4U);
}

TEST(Strategies, AmongEqualsTheOldestFrontierIsTaken) {
  Situation now = situation();
  now.options = {option(7, 1.0, 0.0, 1.0, 1.0, 0.0), option(5, -1.0, 0.0, 1.0, 1.0, 0.0)};
  now.travelFrom = [](std::size_t) { return std::vector<double>{2.0, 2.0}; };
  now.travelHome = [] { return std::vector<double>{0.0, 0.0}; };
  for (const std::string& name : strategyNames()) {
    if (name != kWallFollowing && name != "nearest_to_origin") {
      EXPECT_EQ(now.options[makeStrategy(name)->choose(now)].frontier, 5U) << name;
    }
  }
}

TEST(Strategies, AllNamesAreKnownAndNoOthers) {
  for (const std::string& name : strategyNames()) {
    EXPECT_EQ(makeStrategy(name) == nullptr, name == kWallFollowing);
  }
  EXPECT_THROW((void)makeStrategy("nearest"), std::invalid_argument);
}

/// Stops on a line [m], the robot at 0, home at the other place.
TourCosts onALine(const std::vector<double>& stops, double home) {
  TourCosts costs;
  for (const double from : stops) {
    costs.start.push_back(std::abs(from));
    costs.end.push_back(std::abs(from - home));
    costs.between.emplace_back();
    for (const double to : stops) {
      costs.between.back().push_back(std::abs(from - to));
    }
  }
  return costs;
}

TEST(Tour, CostsItsLengthAndTheWaysUntilStopsAreReached) {
  EXPECT_THAT(costsByFirst(onALine({2.0}, 3.0), 1.0), ElementsAre(3.0 + 2.0));
  // The best tours are 2, 4, -1; or -1, 2, 4; or 4, 2, -1; then home at -3.
  EXPECT_THAT(costsByFirst(onALine({2.0, -1.0, 4.0}, -3.0), 1.0),
              ElementsAre(11.0 + 2.0 + 4.0 + 9.0, 13.0 + 1.0 + 4.0 + 6.0, 11.0 + 4.0 + 6.0 + 9.0));
  EXPECT_THAT(costsByFirst(onALine({2.0, -1.0, 4.0}, -3.0), 0.5),
              ElementsAre(11.0 + 7.5, 13.0 + 5.5, 11.0 + 9.5));
  EXPECT_TRUE(costsByFirst({}, 1.0).empty());
}

/// Which of the stops on a line a tour that ends at home goes to first.
/// @param current the stop that the robot is on its way to, as they are counted from 1
double firstOnALine(const std::vector<double>& stops, double home, FrontierId current = 0) {
  Situation now;
  now.current = current;
  for (const double stop : stops) {
    now.options.push_back(option(now.options.size() + 1, stop, 0.0, std::abs(stop), 1.0, 0.0));
  }
  const TourCosts costs = onALine(stops, home);
  now.travelFrom = [&](std::size_t from) { return costs.between[from]; };
  now.travelHome = [&] { return costs.end; };
  return stops[makeStrategy("tour")->choose(now)];
}

TEST(Tour, LeavesForLastWhatLiesOnTheWayHome) {
  EXPECT_EQ(firstOnALine({-5.0, 6.0}, -9.0), 6.0);
  EXPECT_EQ(firstOnALine({-5.0, 6.0}, 9.0), -5.0);
}

TEST(Tour, IfItIsAsShortEitherWayRoundTakesTheNearestFirst) {
  EXPECT_EQ(firstOnALine({5.0, -3.0}, 0.0), -3.0);
  EXPECT_EQ(firstOnALine({11.0, 5.0, 8.0}, 0.0), 5.0);
}

TEST(Tour, TakesAlongTheSmallOneThatWouldBeLeftBehind) {
  EXPECT_EQ(firstOnALine({2.0, 3.0, 4.0, -1.0}, 4.0), -1.0);
}

TEST(Tour, FrontiersBesideEachOtherAreOneStop) {
  // Either way round is as long, so that early arrival decides.
  EXPECT_EQ(firstOnALine({4.0, 6.3, 8.6, 10.9, -3.0}, 0.0), 4.0);
  EXPECT_EQ(firstOnALine({4.0, 4.3, 4.6, 4.9, -3.0}, 0.0), -3.0);
}

TEST(Tour, TurnsRoundUnderWayOnlyIfItIsWorthIt) {
  EXPECT_EQ(firstOnALine({5.0, -4.8}, 0.0), -4.8);
  EXPECT_EQ(firstOnALine({5.0, -4.8}, 0.0, 1), 5.0);
  EXPECT_EQ(firstOnALine({5.0, -1.0}, 0.0, 1), -1.0);
}

TEST(Tour, GoesOnToItsFrontierAlthoughOneBesideItIsNearer) {
  EXPECT_EQ(firstOnALine({5.0, 4.2}, 0.0), 4.2);
  EXPECT_EQ(firstOnALine({5.0, 4.2}, 0.0, 1), 5.0);
}

TEST(InformationGain, IsTheUnknownAreaInReachThatNoWallHides) {
  const auto nothing = test::drawnMap({"???", "?.?", "???"}, 0.05);
  EXPECT_NEAR(expectedGain(MapView(nothing), {0.075, 0.075}, 1.0), geometry::kPi, 0.2);
  const auto closed = test::drawnMap({"###", "#.#", "###"}, 0.05);
  EXPECT_EQ(expectedGain(MapView(closed), {0.075, 0.075}, 1.0), 0.0);
}

std::vector<std::string> hall() {
  std::vector<std::string> rows(60, "#" + std::string(98, '.') + "#");
  rows.front() = rows.back() = std::string(100, '#');
  return rows;
}

TEST(WallFollower, KeepsTheWallAtItsSide) {
  const auto map = test::drawnMap(hall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  WallFollower follower(0.0, 1);
  geometry::Pose2 pose{1.0, 0.4, 0.0};  // the wall on the right
  for (int i = 0; i < 60; ++i) {
    const auto next = follower.next(room, pose);
    ASSERT_TRUE(next);
    EXPECT_TRUE(room.hasRoomAt(view.cellAt(next->translation())));
    pose = *next;
    const double to_wall = std::min(std::min(pose.x, 5.0 - pose.x), std::min(pose.y, 3.0 - pose.y));
    EXPECT_LT(to_wall, 0.9) << i;
  }
}

TEST(WallFollower, GoesRoundTheHallAlthoughTheRobotArrivesBesideItsGoals) {
  const auto map = test::drawnMap(hall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  WallFollower follower(0.0, 1);
  geometry::Pose2 pose{1.0, 0.4, 0.0};
  bool was_far = false;
  bool is_back = false;
  for (int i = 0; i < 60; ++i) {
    const auto next = follower.next(room, pose);
    ASSERT_TRUE(next);
    // A little nearer to the wall on the right than it was to be, where there is no room any more.
    pose = *next * geometry::Pose2{0.0, -0.08, 0.0};
    was_far = was_far || (pose.x > 4.0 && pose.y > 2.0);
    is_back = is_back || (was_far && pose.x < 1.0 && pose.y < 1.0);
  }
  EXPECT_TRUE(is_back);
}

TEST(WallFollower, ChangesSidesByChance) {
  const auto map = test::drawnMap(hall(), 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  WallFollower same(0.0, 1);
  WallFollower other(1.0, 1);
  const geometry::Pose2 pose{2.5, 0.4, 0.0};
  EXPECT_NEAR(same.next(room, pose)->y, pose.y, 0.2);
  EXPECT_GT(other.next(room, pose)->y, pose.y + 0.3);
}

TEST(WallFollower, WithoutRoomThereIsNoStep) {
  const auto map = test::drawnMap({"###", "#.#", "###"}, 0.05);
  const MapView view(map);
  const StandingRoom room(view, 0.2);
  EXPECT_FALSE(WallFollower(0.0, 1).next(room, {0.075, 0.075, 0.0}));
}

}  // namespace
}  // namespace omega_slam::exploration
