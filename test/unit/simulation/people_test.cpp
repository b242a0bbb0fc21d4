#include "omega_slam/simulation/people.h"

#include <gtest/gtest.h>

#include <limits>

#include "omega_slam/simulation/turtlebot.h"
#include "support/drawn_world.h"

namespace omega_slam::simulation {
namespace {

const Disc kNobody{{100.0, 100.0}, 0.177};

TEST(People, WalkUpAndDownTheirRoute) {
  People people(PeopleConfig{}, {{{0.0, 0.0}, {0.8, 0.0}, {0.8, 0.8}}});
  for (int i = 0; i < 100; ++i) {
    people.step(0.02, kNobody);
  }
  EXPECT_LT((people.discs().at(0).center - Eigen::Vector2d(0.8, 0.8)).norm(), 1e-6);
  for (int i = 0; i < 100; ++i) {
    people.step(0.02, kNobody);
  }
  EXPECT_LT((people.discs().at(0).center - Eigen::Vector2d(0.0, 0.0)).norm(), 1e-6);
}

TEST(People, StopBeforeARobotAndTurnRound) {
  People people(PeopleConfig{}, {{{0.0, 0.0}, {3.0, 0.0}}});
  const Disc robot{{1.5, 0.0}, 0.177};
  double farthest = 0.0;
  for (int i = 0; i < 280; ++i) {  // until it is on its way back
    people.step(0.02, robot);
    farthest = std::max(farthest, people.discs().at(0).center.x());
  }
  EXPECT_NEAR(farthest, 1.5 - 0.177 - 0.2 - 0.3, 0.02);
  EXPECT_LT(people.discs().at(0).center.x(), farthest);
}

TEST(People, RefuseRoutesThatAreNone) {
  EXPECT_THROW(People({}, {{{0.0, 0.0}}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(People({}, {{{0.0, 0.0}, {nan, 0.0}}}), std::invalid_argument);
}

TEST(Surroundings, DiscsAreSeenAndStandInTheWay) {
  const auto room = test::emptyRoom(2.0);
  const std::vector<Disc> discs{{{1.0, 0.0}, 0.2}};
  const Surroundings surroundings(*room, discs);
  EXPECT_NEAR(surroundings.castRay({0.0, 0.0}, 0.0, 4.0)->range, 0.8, 1e-9);
  EXPECT_NEAR(surroundings.castRay({0.0, 0.0}, 1.5707963, 4.0)->range, 2.0, 1e-6);
  EXPECT_FALSE(surroundings.castRay({0.0, 0.0}, 0.0, 0.7));
  EXPECT_EQ(surroundings.castRay({1.1, 0.0}, 0.0, 4.0)->range, 0.0);
  const auto nearest = surroundings.nearestObstacle({0.5, 0.0}, 0.5);
  ASSERT_TRUE(nearest);
  EXPECT_LT((*nearest - Eigen::Vector2d(0.8, 0.0)).norm(), 1e-9);
  EXPECT_FALSE(surroundings.nearestObstacle({0.5, 0.0}, 0.29));
}

TEST(TurtleBot, BumpsIntoWhoStandsInItsWay) {
  TurtleBot robot(test::emptyRoom(3.0), {0.0, 0.0, 0.0}, TurtleBotConfig{});
  PeopleConfig still;
  still.speed = 0.0;
  robot.meet(People(still, {{{1.0, 0.0}, {1.0, 1.0}}}));
  for (int i = 0; i < 300; ++i) {
    (void)robot.command({0.3, 0.0});
    (void)robot.step();
  }
  EXPECT_EQ(robot.collisions(), 1);
  EXPECT_TRUE(robot.bumper().centre);
  EXPECT_NEAR(robot.truth().T_world_base.x, 1.0 - 0.2 - 0.177, 1e-3);
}

}  // namespace
}  // namespace omega_slam::simulation
