#include "omega_slam/navigation/global_planner.h"

#include <gtest/gtest.h>

#include "support/drawn_map.h"

namespace omega_slam::navigation {
namespace {

constexpr double kRadius = 0.2;

/// A character is half a metre: two rooms with a door, a store without one, a corner not seen yet.
const std::vector<std::string> kRooms{"##############",  //
                                      "#      #  ####",  //
                                      "#      #  #  #",  //
                                      "#         #  #",  //
                                      "#      #  ####",  //
                                      "#      #    ??",  //
                                      "#      #    ??",  //
                                      "##############"};

Costmap roomsCostmap() {
  Costmap costmap(CostmapConfig{});
  costmap.setMap(test::drawnMap(kRooms, 0.05, 10));
  return costmap;
}

Plan planFrom(const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
              const Costmap& costmap = roomsCostmap()) {
  return GlobalPlanner(PlannerConfig{}, kRadius).plan(costmap, start, goal);
}

TEST(GlobalPlanner, LeadsThroughTheDoor) {
  const Plan plan = planFrom({1.0, 1.0}, {4.5, 1.0});
  ASSERT_TRUE(plan.found()) << plan.reason;
  EXPECT_EQ(plan.path.front(), Eigen::Vector2d(1.0, 1.0));
  EXPECT_EQ(plan.path.back(), Eigen::Vector2d(4.5, 1.0));
  EXPECT_EQ(plan.leave, 0.0);
  EXPECT_GT(lengthOf(plan.path), 4.0);
  EXPECT_LT(lengthOf(plan.path), 5.5);
}

TEST(GlobalPlanner, SaysWhyThereIsNoPlan) {
  const Eigen::Vector2d start(1.0, 1.0);
  const struct {
    Eigen::Vector2d goal;
    PlanStatus status;
  } cases[] = {{{3.7, 1.0}, PlanStatus::kGoalOccupied},    {{9.0, 1.0}, PlanStatus::kGoalOutside},
               {{6.7, 0.8}, PlanStatus::kGoalUnknown},     {{5.9, 2.5}, PlanStatus::kNoWay},
               {{0.0 / 0.0, 1.0}, PlanStatus::kNotFinite}, {{1e300, 1.0}, PlanStatus::kNotFinite}};
  for (const auto& one : cases) {
    const Plan plan = planFrom(start, one.goal);
    EXPECT_EQ(plan.status, one.status) << plan.reason;
    EXPECT_FALSE(plan.reason.empty());
    EXPECT_FALSE(plan.passing);
  }
  EXPECT_EQ(planFrom({-1.0, 0.0}, start).status, PlanStatus::kStartOutside);
  EXPECT_EQ(planFrom({0.2, 1.0}, start).status, PlanStatus::kStartBlocked);
  EXPECT_EQ(planFrom(start, start, Costmap(CostmapConfig{})).status, PlanStatus::kNoMap);
}

TEST(GlobalPlanner, MovesAGoalBesideAWallToWhereTheRobotFits) {
  const Plan near = planFrom({1.0, 1.0}, {0.6, 2.0});  // 0.1 m from the wall
  ASSERT_TRUE(near.found()) << near.reason;
  EXPECT_NEAR(near.path.back().x(), 0.72, 0.06);
  PlannerConfig strict;
  strict.goal_tolerance = 0.0;
  const Plan refused = GlobalPlanner(strict, kRadius).plan(roomsCostmap(), {1.0, 1.0}, {0.6, 2.0});
  EXPECT_EQ(refused.status, PlanStatus::kGoalTooNarrow);
}

TEST(GlobalPlanner, LeavesAPlaceWhereTheRobotDoesNotFitFirst) {
  const Plan plan = planFrom({0.65, 2.0}, {3.0, 2.0});  // 0.15 m from the wall
  ASSERT_TRUE(plan.found()) << plan.reason;
  EXPECT_GT(plan.leave, 0.0);
  EXPECT_LT(plan.leave, 0.3);
  EXPECT_EQ(plan.path.front(), Eigen::Vector2d(0.65, 2.0));
}

TEST(GlobalPlanner, LeavesTowardsWhereTheGoalIs) {
  // Nothing is known of where the robot stands; the nearest place that is leads nowhere.
  Costmap costmap(CostmapConfig{});
  costmap.setMap(test::drawnMap({"????????????",  //
                                 "????      ??",  //
                                 "? ??      ??",  //
                                 "????      ??",  //
                                 "????????????"},
                                0.05, 10));
  const Plan plan = planFrom({1.25, 1.25}, {4.0, 1.25}, costmap);
  ASSERT_TRUE(plan.found()) << plan.reason;
  EXPECT_GT(plan.leave, 0.9);
}

/// A hall of 40 by 40 m, with a post beside which a robot barely stands.
Costmap hallWithPost() {
  grid::OccupancyGrid map = grid::makeGrid({0.1, {0.0, 0.0}, 400, 400}, grid::kFree);
  map.at({200, 200}) = grid::kOccupied;
  Costmap costmap(CostmapConfig{});
  costmap.setMap(map);
  return costmap;
}

TEST(GlobalPlanner, LooksNoFartherWhereTheRobotMustLeaveFirst) {
  const Costmap costmap = hallWithPost();
  const Plan plan = planFrom({20.25, 20.05}, {23.0, 20.0}, costmap);
  ASSERT_TRUE(plan.found()) << plan.reason;
  EXPECT_GT(plan.leave, 0.0);
  EXPECT_LT(plan.looked, 4000U);  // of 160000
}

TEST(GlobalPlanner, RefusesWhatItHasNoTimeToDecide) {
  const Costmap costmap = hallWithPost();
  PlannerConfig config;
  config.max_cells = 100;
  const Plan plan = GlobalPlanner(config, kRadius).plan(costmap, {1.0, 1.0}, {39.0, 38.0});
  EXPECT_EQ(plan.status, PlanStatus::kUndecided);
  EXPECT_LE(plan.looked, 200U);
  EXPECT_NE(plan.reason.find("among 100 cells"), std::string::npos) << plan.reason;
}

TEST(GlobalPlanner, TellsWhatStandsInTheWayFromWhatIsBuiltThere) {
  Costmap costmap = roomsCostmap();
  Sighting sighting;
  sighting.origin = {3.0, 2.25};
  for (double y = 2.0; y <= 2.5; y += 0.02) {
    sighting.returns.emplace_back(3.75, y);  // in the door
  }
  costmap.see(sighting, {3.0, 2.25});
  const Plan blocked = planFrom({1.0, 1.0}, {4.5, 1.0}, costmap);
  EXPECT_EQ(blocked.status, PlanStatus::kNoWay);
  EXPECT_TRUE(blocked.passing);
  costmap.forgetLive();
  EXPECT_TRUE(planFrom({1.0, 1.0}, {4.5, 1.0}, costmap).found());
}

TEST(GlobalPlanner, LeadsAroundWhatWasTouchedFarAway) {
  // Two doors, and a pane in the nearer one; the robot is far from both.
  Costmap costmap(CostmapConfig{});
  costmap.setMap(test::drawnMap({"#########################",  //
                                 "#                       #",  //
                                 "#                    ####",  //
                                 "#                    #  #",  //
                                 "#                       #",  //
                                 "#                    #  #",  //
                                 "#                    #  #",  //
                                 "#                    #  #",  //
                                 "#                       #",  //
                                 "#                    #  #",  //
                                 "#########################"},
                                0.05, 10));
  const Eigen::Vector2d start(1.0, 3.2);
  const Eigen::Vector2d goal(11.6, 3.2);
  const auto doorOf = [&](const Plan& plan) {
    return PathMeasure(plan.path).at(lengthOf(plan.path) - 0.8).y();
  };
  EXPECT_GT(doorOf(planFrom(start, goal, costmap)), 2.5);
  std::vector<Eigen::Vector2d> pane;
  for (double y = 3.0; y <= 3.5; y += 0.04) {
    pane.emplace_back(10.75, y);
  }
  costmap.touch(pane, 0.0);
  costmap.forgetSeen();
  const Plan around = planFrom(start, goal, costmap);
  ASSERT_TRUE(around.found()) << around.reason;
  EXPECT_LT(doorOf(around), 2.5);
  costmap.expire(CostmapConfig{}.contact_memory + 1.0);
  EXPECT_GT(doorOf(planFrom(start, goal, costmap)), 2.5);
}

TEST(GlobalPlanner, KeepsOffWallsFarFromWhatItSees) {
  Costmap costmap(CostmapConfig{});
  costmap.setMap(test::drawnMap({std::string(60, '#'), std::string(60, ' '), std::string(60, ' '),
                                 std::string(60, ' '), std::string(60, '#')},
                                0.05, 10));
  Sighting sighting;
  sighting.origin = {1.0, 1.25};
  sighting.returns.emplace_back(1.0, 0.5);
  costmap.see(sighting, {1.0, 1.25});
  EXPECT_GT(costmap.clearance({20.0, 1.25}), 0.5);
}

/// What a noisy laser sees of a door's posts, a little before they are.
Sighting noisyPosts(double before) {
  Sighting sighting;
  sighting.origin = {0.75, 0.75};
  for (double x = 1.5; x <= 1.75; x += 0.02) {
    sighting.returns.emplace_back(x, 0.5 + before);
    sighting.returns.emplace_back(x, 1.0 - before);
  }
  return sighting;
}

TEST(GlobalPlanner, TakesReturnsBesideAWallForTheWall) {
  const std::vector<std::string> narrow{"#############",  //
                                        "#     #     #",  //
                                        "#     #     #",  //
                                        "#           #",  //
                                        "#           #",  //
                                        "#     #     #",  //
                                        "#############"};
  Costmap costmap(CostmapConfig{});
  costmap.setMap(test::drawnMap(narrow, 0.05, 5));
  costmap.see(noisyPosts(0.03), {0.75, 0.75});
  EXPECT_TRUE(planFrom({0.75, 0.75}, {2.5, 0.75}, costmap).found());
  costmap.see(noisyPosts(0.08), {0.75, 0.75});
  EXPECT_FALSE(planFrom({0.75, 0.75}, {2.5, 0.75}, costmap).found());
}

TEST(GlobalPlanner, RefusesWrongConfigurations) {
  PlannerConfig config;
  config.planner = "crystal ball";
  EXPECT_THROW(GlobalPlanner(config, kRadius), std::invalid_argument);
  EXPECT_THROW(GlobalPlanner(PlannerConfig{}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::navigation
