#include "navigation/goals.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "omega_slam/navigation/sighting.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/simulation/turtlebot.h"

namespace omega_slam::experiments {
namespace {

using navigation::NavigationState;

constexpr double kPatience = 600.0;  // [s]
constexpr int kStepsPerCommand = 5;  // of the physics: ten commands a second

/// A robot in its world, with the navigator at its controls.
class Driver {
 public:
  Driver(const Course& course, simulation::TurtleBot robot)
      : navigator_(course.navigator({})), robot_(std::move(robot)) {}

  [[nodiscard]] const navigation::Navigator& navigator() const { return navigator_; }
  [[nodiscard]] const simulation::TurtleBot& robot() const { return robot_; }

  [[nodiscard]] GoalResult driveTo(const Eigen::Vector2d& goal) {
    GoalResult result;
    const double start = robot_.time();
    const int collisions = robot_.collisions();
    result.nearest_person = std::numeric_limits<double>::infinity();
    navigator_.setGoal({goal, std::nullopt}, start);
    result.outcome = "took too long";
    while (robot_.time() - start < kPatience) {
      const navigation::NavigatorStep step = command();
      pass(result);
      if (step.state == NavigationState::kReached || step.state == NavigationState::kFailed) {
        result.outcome = step.state == NavigationState::kReached ? "reached" : step.reason;
        break;
      }
    }
    navigator_.cancel();
    result.seconds = robot_.time() - start;
    result.collisions = robot_.collisions() - collisions;
    return result;
  }

  /// Lets time pass without a goal, so that there is a scan when the first one comes.
  void look() {
    GoalResult nobody;
    for (int i = 0; i < 3; ++i) {
      (void)command();
      pass(nobody);
    }
  }

 private:
  [[nodiscard]] navigation::NavigatorStep command() {
    const simulation::GroundTruth truth = robot_.truth();
    const auto step =
        navigator_.step(truth.stamp, geometry::StampedPose2{truth.stamp, truth.T_world_base},
                        robot_.now().odometry.velocity);
    (void)robot_.command(step.velocity);
    return step;
  }

  /// Until the next command.
  void pass(GoalResult& result) {
    for (int i = 0; i < kStepsPerCommand; ++i) {
      const geometry::Pose2 before = robot_.truth().T_world_base;
      const simulation::TurtleBotEvents events = robot_.step();
      const geometry::Pose2& after = events.truth.T_world_base;
      result.driven += geometry::distance(before, after);
      for (const simulation::Disc& disc : robot_.people().discs()) {
        const double gap = (disc.center - after.translation()).norm() - disc.radius -
                           robot_.config().kobuki.radius;
        result.nearest_person = std::min(result.nearest_person, gap);
      }
      see(events, after);
    }
  }

  void see(const simulation::TurtleBotEvents& events, const geometry::Pose2& T_map_base) {
    poses_.push_back({events.truth.stamp, T_map_base});
    if (events.bumper && events.bumper->any()) {
      const double x = robot_.config().kobuki.radius;
      navigator_.touch({{x, 0.0}}, events.truth.stamp);
    }
    if (!events.scan) {
      return;
    }
    const auto first = std::find_if(poses_.begin(), poses_.end(), [&](const auto& pose) {
      return pose.stamp >= events.scan->stamp - 1e-6;
    });
    const auto taken = intake_.process(*events.scan, {robot_.config().T_base_laser, false},
                                       relativePose(first->pose, poses_.back().pose));
    if (taken.sweep) {
      navigator_.see(navigation::sightingFrom(*taken.sweep), first->pose * taken.T_start_sweep);
    }
    poses_.erase(poses_.begin(), std::prev(poses_.end()));
  }

  navigation::Navigator navigator_;
  simulation::TurtleBot robot_;
  sensing::ScanIntake intake_{sensing::ScanIntakeConfig{}};
  geometry::Trajectory poses_;  ///< since the last scan
};

simulation::TurtleBot makeRobot(const Course& course, const GoalTrial& trial,
                                std::mt19937_64& random) {
  navigation::Costmap costmap{navigation::CostmapConfig{}};
  costmap.setMap(course.map);
  // Not in a closet: from the start there is a way to most other places.
  const navigation::GlobalPlanner planner({}, course.footprint.circumscribed_radius + 0.05);
  constexpr int kProbes = 9;
  while (true) {
    const Eigen::Vector2d start = course.placeToStand(costmap, random);
    int ways = 0;
    for (int i = 0; i < kProbes; ++i) {
      ways += planner.plan(costmap, start, course.placeToStand(costmap, random)).found() ? 1 : 0;
    }
    if (2 * ways > kProbes) {
      simulation::TurtleBotConfig config;
      config.seed = trial.seed;
      return {course.world, {start.x(), start.y(), 0.0}, config};
    }
  }
}

}  // namespace

std::vector<GoalResult> driveToGoals(const Course& course, const GoalTrial& trial) {
  std::mt19937_64 random(trial.seed);
  simulation::TurtleBot robot = makeRobot(course, trial, random);
  robot.meet(course.people(trial.people, random));
  Driver driver(course, std::move(robot));
  driver.look();
  const navigation::Navigator map_alone = course.navigator({});
  std::bernoulli_distribution is_anywhere(trial.anywhere);
  std::vector<GoalResult> results;
  while (results.size() < trial.goals) {
    const Eigen::Vector2d goal = is_anywhere(random)
                                     ? course.anywhere(random)
                                     : course.placeToStand(map_alone.costmap(), random);
    const Eigen::Vector2d from = driver.robot().truth().T_world_base.translation();
    const navigation::Plan plan = map_alone.plan(from, goal);
    GoalResult result = driver.driveTo(goal);
    result.wanted = plan.found() ? "reached" : plan.reason;
    result.planned = navigation::lengthOf(plan.path);
    // What the reason says of where the robot stands may have changed on the way there.
    const auto kind = [](const std::string& reason) { return reason.substr(0, 12); };
    result.right = kind(result.wanted) == kind(result.outcome);
    results.push_back(result);
  }
  return results;
}

}  // namespace omega_slam::experiments
