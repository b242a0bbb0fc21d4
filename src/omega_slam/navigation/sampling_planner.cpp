#include "omega_slam/navigation/sampling_planner.h"

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <chrono>
#include <memory>
#include <stdexcept>

namespace omega_slam::navigation {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kMargin = 1.0;  // [m] about the given path in which samples are drawn

Eigen::Vector2d pointOf(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

/// A straight motion, checked by the distance field and not in steps.
class LineValidator : public ob::MotionValidator {
 public:
  LineValidator(const ob::SpaceInformationPtr& space, const Costmap& costmap, double radius)
      : ob::MotionValidator(space), costmap_(costmap), radius_(radius) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return costmap_.isFree(pointOf(from), pointOf(to), radius_);
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    const bool valid = checkMotion(from, to);
    if (!valid) {  // how far it would have been free, nobody here asks
      si_->copyState(last_valid.first != nullptr ? last_valid.first : nullptr, from);
      last_valid.second = 0.0;
    }
    return valid;
  }

 private:
  const Costmap& costmap_;
  double radius_;
};

/// Length, times what room costs.
class ClearanceObjective : public ob::PathLengthOptimizationObjective {
 public:
  ClearanceObjective(const ob::SpaceInformationPtr& space, const Costmap& costmap,
                     const ClearanceCost& cost)
      : ob::PathLengthOptimizationObjective(space), costmap_(costmap), cost_(cost) {}

  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(cost_.ofLine(costmap_, pointOf(from), pointOf(to)));
  }

 private:
  const Costmap& costmap_;
  ClearanceCost cost_;
};

ob::PlannerPtr makePlanner(const std::string& name, const ob::SpaceInformationPtr& space) {
  if (name == "RRTConnect") {
    return std::make_shared<og::RRTConnect>(space);
  }
  if (name == "RRTstar") {
    return std::make_shared<og::RRTstar>(space);
  }
  if (name == "InformedRRTstar") {
    return std::make_shared<og::InformedRRTstar>(space);
  }
  if (name == "PRMstar") {
    return std::make_shared<og::PRMstar>(space);
  }
  throw std::invalid_argument("There is no sampling planner \"" + name + "\".");
}

ob::StateSpacePtr spaceAbout(const Path& path) {
  Eigen::Vector2d low = path.front();
  Eigen::Vector2d high = path.front();
  for (const Eigen::Vector2d& point : path) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, low[axis] - kMargin);
    bounds.setHigh(axis, high[axis] + kMargin);
  }
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(bounds);
  return space;
}

ob::ProblemDefinitionPtr problemOf(const ob::SpaceInformationPtr& space, const Costmap& costmap,
                                   const ClearanceCost& cost, const Path& around) {
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  const auto stateAt = [&](const Eigen::Vector2d& point) {
    ob::ScopedState<> state(space);
    state[0] = point.x();
    state[1] = point.y();
    return state;
  };
  problem->setStartAndGoalStates(stateAt(around.front()), stateAt(around.back()));
  problem->setOptimizationObjective(std::make_shared<ClearanceObjective>(space, costmap, cost));
  return problem;
}

/// Ends after so many questions, or so much time.
ob::PlannerTerminationCondition conditionOf(const SamplingLimits& limits) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limits.time);
  const auto left = std::make_shared<int>(limits.iterations);
  return ob::PlannerTerminationCondition(
      [end, left] { return (*left)-- <= 0 || std::chrono::steady_clock::now() >= end; });
}

}  // namespace

const std::vector<std::string>& samplingPlannerNames() {
  static const std::vector<std::string> names{"RRTConnect", "RRTstar", "InformedRRTstar",
                                              "PRMstar"};
  return names;
}

std::optional<Path> samplePath(const std::string& name, const Costmap& costmap,
                               const ClearanceCost& cost, const Path& around,
                               const SamplingLimits& limits) {
  // OMPL would write to the terminal, and complain of seeds that are set anew.
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(limits.seed));
  const auto space = std::make_shared<ob::SpaceInformation>(spaceAbout(around));
  space->setStateValidityChecker([&costmap, radius = cost.radius](const ob::State* state) {
    return costmap.isFree(pointOf(state), radius);
  });
  space->setMotionValidator(std::make_shared<LineValidator>(space, costmap, cost.radius));
  space->setup();
  const auto problem = problemOf(space, costmap, cost, around);
  const auto planner = makePlanner(name, space);
  planner->setProblemDefinition(problem);
  planner->setup();
  if (planner->solve(conditionOf(limits)) != ob::PlannerStatus::EXACT_SOLUTION) {
    return std::nullopt;
  }
  const auto* solution = problem->getSolutionPath()->as<og::PathGeometric>();
  Path path;
  for (std::size_t i = 0; i < solution->getStateCount(); ++i) {
    path.push_back(pointOf(solution->getState(static_cast<unsigned>(i))));
  }
  return path;
}

}  // namespace omega_slam::navigation
