#include "omega_slam/exploration/explorer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "omega_slam/exploration/standing_room.h"
#include "omega_slam/exploration/strategy_factory.h"
#include "support/drawn_world.h"
#include "support/toy_robot.h"

namespace omega_slam::exploration {
namespace {

using geometry::Pose2;
using ::testing::HasSubstr;

/// Three rooms in a row, 9 x 3 m, with doors of 1 m.
std::shared_ptr<const simulation::World> threeRooms() {
  std::vector<std::string> rows(30, "#" + std::string(88, ' ') + "#");
  rows.front() = rows.back() = std::string(90, '#');
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows[row][30] = row >= 4 && row < 14 ? ' ' : '#';
    rows[row][60] = row >= 16 && row < 26 ? ' ' : '#';
  }
  return test::drawnWorld(rows, 0.1);
}

constexpr Pose2 kStart{1.0, 1.0, 0.5};

ExplorerConfig configOf(const std::string& strategy) {
  ExplorerConfig config;
  config.strategy = strategy;
  return config;
}

double knownShare(const grid::OccupancyGrid& map) {
  const auto known = std::count_if(map.cells.begin(), map.cells.end(),
                                   [](std::int8_t value) { return value != grid::kUnknown; });
  return static_cast<double>(known) * 0.0025 / (8.9 * 2.9);
}

class EveryStrategy : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryStrategy, ExploresAllAndComesHome) {
  Explorer explorer(configOf(GetParam()));
  test::ToyRobot robot(threeRooms(), kStart);
  EXPECT_TRUE(explorer.start().success);
  robot.look(explorer);
  ASSERT_TRUE(robot.run(explorer, 2000)) << explorer.progress().distance;
  EXPECT_EQ(explorer.ending(), Ending::kDone) << explorer.reason();
  EXPECT_GT(knownShare(robot.map()), 0.98);
  EXPECT_LT(geometry::distance(robot.pose(), kStart), 0.4);
  EXPECT_THAT(explorer.reason(), HasSubstr("home"));
  EXPECT_GT(explorer.progress().share, 0.97);
  EXPECT_GT(explorer.progress().distance, 10.0);
}

INSTANTIATE_TEST_SUITE_P(Strategies, EveryStrategy, ::testing::ValuesIn(strategyNames()),
                         [](const auto& param_info) { return param_info.param; });

/// Under way, with a goal, after some ticks.
struct UnderWay {
  Explorer explorer;
  test::ToyRobot robot{threeRooms(), kStart};

  explicit UnderWay(const ExplorerConfig& config = configOf("nearest_to_robot"), int ticks = 8)
      : explorer(config) {
    (void)explorer.start();
    robot.look(explorer);
    for (int i = 0; i < ticks || (!robot.isDriving() && explorer.phase() != Phase::kEnded); ++i) {
      robot.tick(explorer);
    }
  }
};

TEST(Explorer, DoesNothingBeforeItIsStarted) {
  Explorer explorer;
  test::ToyRobot robot(threeRooms(), kStart);
  robot.look(explorer);
  robot.tick(explorer);
  EXPECT_TRUE(robot.orders().empty());
  EXPECT_EQ(explorer.phase(), Phase::kIdle);
  EXPECT_FALSE(explorer.stop().success);
  EXPECT_FALSE(explorer.pause().success);
  EXPECT_FALSE(explorer.resume().success);
}

/// A wall of 20 m with a gap of so many cells, from which a frontier runs along its far side.
/// Two ways lead past a block to its two ends.
std::shared_ptr<const grid::OccupancyGrid> longFrontier(int first_row, int last_row) {
  auto map = std::make_shared<grid::OccupancyGrid>(
      grid::makeGrid({0.1, {0.0, 0.0}, 60, 100}, grid::kFree));
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 60; ++column) {
      const bool is_edge = row == 0 || row == 99 || column == 0;
      const bool is_block = column >= 20 && column < 50 && row >= 10 && row < 90;
      const bool is_comb = column >= 50 && row == 50;  // nobody passes along the frontier
      if (is_edge || is_block || is_comb) {
        map->at({column, row}) = grid::kOccupied;
      }
    }
    const bool is_frontier = row >= first_row && row <= last_row;
    map->at({59, row}) = is_frontier ? grid::kUnknown : grid::kOccupied;
    map->at({58, row}) = is_frontier && row == 50 ? grid::kUnknown : map->at({58, row});
  }
  return map;
}

TEST(Explorer, TurnsRoundForTheSameFrontierOnlyIfItIsWorthIt) {
  Explorer explorer(configOf("nearest_to_robot"));
  (void)explorer.start();
  explorer.showMap(longFrontier(30, 66));
  const Order first = explorer.update(0.0, Pose2{1.0, 4.5, 0.0});
  ASSERT_EQ(first.kind, Order::Kind::kGo);
  EXPECT_LT(first.goal.T_map_base.y, 5.0);
  explorer.showMap(longFrontier(36, 74));  // now its middle is on the other side
  EXPECT_EQ(explorer.update(2.0, Pose2{1.0, 4.4, 0.0}).kind, Order::Kind::kKeepOn);
  explorer.showMap(longFrontier(66, 80));  // and here nothing is left of it
  const Order last = explorer.update(4.0, Pose2{1.0, 4.3, 0.0});
  ASSERT_EQ(last.kind, Order::Kind::kGo);
  EXPECT_GT(last.goal.T_map_base.y, 5.0);
}

/// A corridor of 20 m with a frontier at its right end, and perhaps another one at its left.
std::shared_ptr<const grid::OccupancyGrid> corridor(bool is_open_on_the_left) {
  auto map = std::make_shared<grid::OccupancyGrid>(
      grid::makeGrid({0.1, {0.0, 0.0}, 200, 20}, grid::kFree));
  for (int row = 0; row < 20; ++row) {
    map->at({199, row}) = grid::kUnknown;
    map->at({0, row}) = is_open_on_the_left ? grid::kUnknown : grid::kOccupied;
    for (int column = 0; column < 200 && (row == 0 || row == 19); ++column) {
      map->at({column, row}) = grid::kOccupied;
    }
  }
  return map;
}

TEST(Explorer, ATourTakesAlongWhatComesIntoSightUnderWay) {
  for (const char* strategy : {"tour", "nearest_to_robot"}) {
    Explorer explorer(configOf(strategy));
    (void)explorer.start();
    explorer.showMap(corridor(false));
    const Order first = explorer.update(0.0, Pose2{3.0, 1.0, 0.0});
    ASSERT_EQ(first.kind, Order::Kind::kGo);
    EXPECT_GT(first.goal.T_map_base.x, 18.0);
    EXPECT_EQ(explorer.update(2.0, Pose2{3.1, 1.0, 0.0}).kind, Order::Kind::kKeepOn);
    explorer.showMap(corridor(true));
    const Order next = explorer.update(4.0, Pose2{3.2, 1.0, 0.0});
    if (explorer.strategy() == "tour") {
      ASSERT_EQ(next.kind, Order::Kind::kGo);
      EXPECT_LT(next.goal.T_map_base.x, 2.0);
      explorer.showMap(corridor(true));
      EXPECT_EQ(explorer.update(6.0, Pose2{3.0, 1.0, 3.1}).kind, Order::Kind::kKeepOn);
    } else {
      EXPECT_EQ(next.kind, Order::Kind::kKeepOn);
    }
  }
}

TEST(Explorer, AlongAWallTheNextStepComesBeforeTheRobotStands) {
  Explorer explorer(configOf("wall_following"));
  test::ToyRobot robot(threeRooms(), kStart);
  (void)explorer.start();
  robot.look(explorer);
  const Order first = explorer.update(0.0, kStart);
  ASSERT_EQ(first.kind, Order::Kind::kGo);
  const Pose2 end = first.goal.T_map_base;
  EXPECT_EQ(explorer.update(0.2, end * Pose2{-0.4, 0.0, 0.0}).kind, Order::Kind::kKeepOn);
  const Order next = explorer.update(0.4, end * Pose2{-0.2, 0.0, 0.0});
  ASSERT_EQ(next.kind, Order::Kind::kGo);
  EXPECT_NEAR(geometry::distance(next.goal.T_map_base, end), 0.5, 1e-9);
  EXPECT_EQ(explorer.update(0.6, end).kind, Order::Kind::kKeepOn);
}

TEST(Explorer, PausesAndGoesOn) {
  UnderWay run;
  ASSERT_TRUE(run.explorer.goal());
  EXPECT_FALSE(run.explorer.start().success);
  EXPECT_TRUE(run.explorer.pause().success);
  run.robot.tick(run.explorer);
  EXPECT_EQ(run.robot.orders().back().kind, Order::Kind::kCancel);
  const std::size_t orders = run.robot.orders().size();
  const double time = run.explorer.progress().time;
  for (int i = 0; i < 20; ++i) {
    run.robot.tick(run.explorer);
  }
  EXPECT_EQ(run.robot.orders().size(), orders);
  EXPECT_EQ(run.explorer.progress().time, time);
  EXPECT_TRUE(run.explorer.resume().success);
  EXPECT_TRUE(run.robot.run(run.explorer, 2000));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone);
}

TEST(Explorer, StopsAtOnceAndCanStartAgain) {
  UnderWay run;
  EXPECT_TRUE(run.explorer.stop().success);
  EXPECT_EQ(run.explorer.ending(), Ending::kStopped);
  run.robot.tick(run.explorer);
  EXPECT_EQ(run.robot.orders().back().kind, Order::Kind::kCancel);
  EXPECT_TRUE(run.explorer.start().success);
  EXPECT_TRUE(run.robot.run(run.explorer, 2000));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone);
}

TEST(Explorer, WithoutAPoseNothingChanges) {
  UnderWay run;
  const std::uint64_t goal = run.explorer.goal()->id;
  const std::size_t frontiers = run.explorer.frontiers().size();
  for (double now = run.robot.now(); now < run.robot.now() + 5.0; now += 0.2) {
    EXPECT_EQ(run.explorer.update(now, std::nullopt).kind, Order::Kind::kKeepOn);
  }
  EXPECT_EQ(run.explorer.phase(), Phase::kExploring);
  EXPECT_EQ(run.explorer.goal()->id, goal);
  EXPECT_EQ(run.explorer.frontiers().size(), frontiers);
}

TEST(Explorer, WithoutAMapItWaits) {
  Explorer explorer;
  (void)explorer.start();
  explorer.showMap(nullptr);
  explorer.showMap(std::make_shared<grid::OccupancyGrid>());
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(explorer.update(i, Pose2{}).kind, Order::Kind::kKeepOn);
  }
  EXPECT_EQ(explorer.phase(), Phase::kExploring);
}

TEST(Explorer, WhatCanNotBeReachedIsSetAsideAndTriedAgain) {
  ExplorerConfig config = configOf("nearest_to_robot");
  UnderWay run(config, 1);
  run.robot.refuseGoalsNear({7.5, 1.5}, 1.6);  // the third room
  ASSERT_TRUE(run.robot.run(run.explorer, 3000));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone);
  ASSERT_FALSE(run.explorer.setAside().empty());
  int failures = 0;
  for (const SetAside& entry : run.explorer.setAside()) {
    failures = std::max(failures, entry.failures);
  }
  EXPECT_EQ(failures, config.max_attempts);
}

TEST(Explorer, IsStuckWhenNoGoalIsEverReached) {
  ExplorerConfig config = configOf("nearest_to_robot");
  config.max_failures = 3;
  config.return_home = false;
  Explorer explorer(config);
  test::ToyRobot robot(threeRooms(), kStart);
  robot.refuseGoalsNear({0.0, 0.0}, 100.0);
  (void)explorer.start();
  robot.look(explorer);
  ASSERT_TRUE(robot.run(explorer, 300));
  EXPECT_EQ(explorer.ending(), Ending::kStuck);
}

TEST(Explorer, KeepsItsBudgets) {
  ExplorerConfig config = configOf("nearest_to_robot");
  config.time_budget = 6.0;
  UnderWay timed(config, 1);
  ASSERT_TRUE(timed.robot.run(timed.explorer, 500));
  EXPECT_EQ(timed.explorer.ending(), Ending::kBudget);
  EXPECT_LT(geometry::distance(timed.robot.pose(), kStart), 0.4);
  config.time_budget = 0.0;
  config.distance_budget = 3.0;
  config.return_home = false;
  UnderWay driven(config, 1);
  ASSERT_TRUE(driven.robot.run(driven.explorer, 500));
  EXPECT_EQ(driven.explorer.ending(), Ending::kBudget);
  EXPECT_NEAR(driven.explorer.progress().distance, 3.0, 0.5);
}

TEST(Explorer, OnTheWayHomeTurnsToWhatAppears) {
  UnderWay run;
  while (run.explorer.phase() != Phase::kReturning) {
    run.robot.tick(run.explorer);
  }
  run.robot.tick(run.explorer);
  ASSERT_GT(geometry::distance(run.robot.pose(), kStart), 1.0);
  const auto whole = std::make_shared<grid::OccupancyGrid>(run.robot.map());
  const auto holed = std::make_shared<grid::OccupancyGrid>(run.robot.map());
  const grid::Cell corner = holed->geometry.cellAt({8.0, 0.5});
  for (int i = 0; i < 100; ++i) {
    holed->at(corner + grid::Cell(i % 10, i / 10)) = grid::kUnknown;
  }
  run.explorer.showMap(holed);
  (void)run.explorer.update(run.robot.now() + 0.1, run.robot.pose());
  ASSERT_EQ(run.explorer.phase(), Phase::kExploring);
  EXPECT_EQ(run.explorer.ending(), Ending::kNone);
  const Order order = run.explorer.update(run.robot.now() + 0.2, run.robot.pose());
  ASSERT_EQ(order.kind, Order::Kind::kGo);
  EXPECT_LT((order.goal.T_map_base.translation() - Eigen::Vector2d(8.25, 0.75)).norm(), 1.0);
  run.explorer.showMap(whole);
  EXPECT_TRUE(run.robot.run(run.explorer, 500));
  EXPECT_THAT(run.explorer.reason(), HasSubstr("home"));
}

TEST(Explorer, StaysWithinAnArea) {
  ExplorerConfig config = configOf("nearest_to_robot");
  config.area = {0.0, 0.0, 3.5, 0.0, 3.5, 3.0, 0.0, 3.0};
  UnderWay run(config, 1);
  ASSERT_TRUE(run.robot.run(run.explorer, 500));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone);
  for (const Order& order : run.robot.orders()) {
    EXPECT_LT(order.goal.T_map_base.x, 3.6);
  }
}

TEST(Explorer, SendsTheRobotNowhereBeyondWhatItHasTouched) {
  UnderWay run(configOf("nearest_to_robot"), 1);
  (void)run.explorer.update(run.robot.now(), run.robot.pose());
  const auto before = static_cast<std::ptrdiff_t>(run.robot.orders().size());
  std::vector<Eigen::Vector2d> pane;  // of glass, in the first door
  for (double y = 1.4; y < 2.8; y += 0.1) {
    pane.push_back(run.robot.pose().inverse() * Eigen::Vector2d(3.05, y));
  }
  run.explorer.touch(pane);
  ASSERT_TRUE(run.robot.run(run.explorer, 500));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone) << run.explorer.reason();
  for (auto order = run.robot.orders().begin() + before; order != run.robot.orders().end();
       ++order) {
    EXPECT_LT(order->goal.T_map_base.x, 3.2);
  }
}

TEST(Explorer, TakesAPaneToFillTheGapInWhichItWasTouched) {
  UnderWay run(configOf("nearest_to_robot"), 1);
  (void)run.explorer.update(run.robot.now(), run.robot.pose());
  const auto before = static_cast<std::ptrdiff_t>(run.robot.orders().size());
  run.explorer.touch({run.robot.pose().inverse() * Eigen::Vector2d(3.02, 1.8)});
  ASSERT_TRUE(run.robot.run(run.explorer, 500));
  for (auto order = run.robot.orders().begin() + before; order != run.robot.orders().end();
       ++order) {
    EXPECT_LT(order->goal.T_map_base.x, 3.2);
  }
}

TEST(Explorer, ComesHomeToWhereItsMapShowsRoom) {
  Explorer explorer(configOf("nearest_to_robot"));
  (void)explorer.start();
  auto map = std::make_shared<grid::OccupancyGrid>(
      grid::makeGrid({0.05, {0.0, 0.0}, 80, 60}, grid::kOccupied));
  for (int row = 1; row < 59; ++row) {
    for (int column = 1; column < 79; ++column) {
      map->at({column, row}) = grid::kFree;
    }
  }
  const Pose2 home{1.02, 1.02, 0.0};
  auto whole = std::make_shared<grid::OccupancyGrid>(*map);
  for (const Cell& step : discAround(1.0)) {  // the laser has never looked back
    map->at(map->geometry.cellAt(home.translation()) + step) = grid::kUnknown;
  }
  explorer.showMap(map);
  (void)explorer.update(1.0, home);
  ASSERT_EQ(explorer.phase(), Phase::kReturning);
  const Order order = explorer.update(2.0, Pose2{3.0, 2.0, 0.0});
  ASSERT_EQ(order.kind, Order::Kind::kGo);
  EXPECT_EQ(map->at(map->geometry.cellAt(order.goal.T_map_base.translation())), grid::kFree);
  EXPECT_LT(geometry::distance(order.goal.T_map_base, home), 0.5);
  explorer.showMap(whole);  // home has been seen on the way
  explorer.goalEnded(order.goal.id, true);
  const Order again = explorer.update(3.0, order.goal.T_map_base);
  ASSERT_EQ(again.kind, Order::Kind::kGo);
  EXPECT_LT(geometry::distance(again.goal.T_map_base, home), 1e-9);
}

TEST(Explorer, GoalsMoveWithTheMap) {
  UnderWay run;
  const Goal before = *run.explorer.goal();
  auto moved = std::make_shared<grid::OccupancyGrid>(run.robot.map());
  moved->geometry.origin += Eigen::Vector2d(1.0, 0.5);
  const geometry::MapMotion motion({kStart}, {{kStart.x + 1.0, kStart.y + 0.5, kStart.theta}});
  run.explorer.showMap(moved, {}, &motion);
  const Pose2 pose{run.robot.pose().x + 1.0, run.robot.pose().y + 0.5, run.robot.pose().theta};
  const Order order = run.explorer.update(run.robot.now() + 0.1, pose);
  ASSERT_EQ(order.kind, Order::Kind::kGo);
  EXPECT_EQ(order.goal.frontier, before.frontier);
  EXPECT_NEAR(order.goal.T_map_base.x, before.T_map_base.x + 1.0, 1e-9);
  EXPECT_NEAR(order.goal.T_map_base.y, before.T_map_base.y + 0.5, 1e-9);
}

TEST(Explorer, ChangesItsStrategyUnderWay) {
  UnderWay run;
  EXPECT_FALSE(run.explorer.setStrategy("fastest").success);
  EXPECT_EQ(run.explorer.strategy(), "nearest_to_robot");
  EXPECT_TRUE(run.explorer.setStrategy("tour").success);
  EXPECT_EQ(run.explorer.strategy(), "tour");
  EXPECT_TRUE(run.robot.run(run.explorer, 2000));
  EXPECT_EQ(run.explorer.ending(), Ending::kDone);
}

TEST(Explorer, RefusesAConfigurationThatIsNoneAndSaysWhy) {
  ExplorerConfig config;
  config.robot_radius = 0.0;
  config.area = {1.0, 2.0};
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(Explorer{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::exploration
