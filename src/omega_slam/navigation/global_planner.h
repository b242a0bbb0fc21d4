#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/path.h"

namespace omega_slam::navigation {

struct PlannerConfig {
  /// "grid": the grid search's path, made straight; or the name of a planner of OMPL, which looks
  /// for a cheaper one near it.
  std::string planner{"grid"};
  int max_cells{1000000};  ///< that the grid search may go on from, by which its time is bounded
  double time_limit{0.2};  ///< [s] of wall time for OMPL
  int iterations{2000};    ///< of OMPL's planner, after which it ends
  int seed{1};             ///< of OMPL
  double preferred_clearance{
      0.5};                      ///< [m] from obstacles to the robot's middle, where there is room
  double clearance_weight{3.0};  ///< a metre without any room to spare costs so much more
  double goal_tolerance{0.2};    ///< [m] a goal is moved so far to where the robot fits
  double leave_distance{1.0};    ///< [m] so far it may drive out of a place where it does not fit

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// The planners that can be asked for by name.
[[nodiscard]] std::vector<std::string> plannerNames();

enum class PlanStatus {
  kFound,
  kNoMap,
  kNotFinite,      ///< start or goal is not a number
  kStartOutside,   ///< of the map
  kStartBlocked,   ///< the robot is in something, and there is no way out of it
  kGoalOutside,    ///< of the map
  kGoalOccupied,   ///< it is in an obstacle
  kGoalUnknown,    ///< what is there is not known
  kGoalTooNarrow,  ///< the robot does not fit there
  kNoWay,          ///< from here to there
  kUndecided       ///< no way was found among as many cells as may be looked at
};

/// A way, or why there is none.
struct Plan {
  PlanStatus status{PlanStatus::kNoMap};
  Path path;            ///< [m] from the start, in the map's frame
  double leave{0.0};    ///< [m] of the path on which the robot leaves a place where it does not fit
  bool passing{false};  ///< there is none now, but the map would have one: something stands there
  std::string reason;   ///< one sentence, where there is none
  std::size_t looked{0};  ///< cells that were gone on from to find out, 2 * max_cells at most

  [[nodiscard]] bool found() const { return status == PlanStatus::kFound; }
};

/// Plans for a round robot, that can turn on the spot: grid search first, which finds a way if
/// there is one at the map's resolution; then, if wanted, OMPL; then the path is made straight and
/// its corners round. Every path returned is free at the robot's radius, but for the first metres
/// where the robot stands too near to something: then it drives straight to where it fits.
class GlobalPlanner {
 public:
  /// @param radius [m] of the robot
  /// @throws std::invalid_argument if the configuration is not valid
  GlobalPlanner(const PlannerConfig& config, double radius);

  /// @param start, goal [m] in the map's frame
  [[nodiscard]] Plan plan(const Costmap& costmap, const Eigen::Vector2d& start,
                          const Eigen::Vector2d& goal) const;
  [[nodiscard]] Plan plan(const Costmap& costmap, const Eigen::Vector2d& start,
                          const Eigen::Vector2d& goal, double goal_tolerance) const;

  [[nodiscard]] ClearanceCost cost() const;

  /// Places where the robot fits that it can drive to straight from where it does not, never nearer
  /// to an obstacle than it already is; the nearest first. The point itself alone, where it fits.
  [[nodiscard]] std::vector<Eigen::Vector2d> exitsFrom(const Costmap& costmap,
                                                       const Eigen::Vector2d& start) const;

 private:
  [[nodiscard]] Plan planOnce(const Costmap& costmap, const Eigen::Vector2d& start,
                              const Eigen::Vector2d& goal, double goal_tolerance) const;
  /// @param exits from the start, one at least; @param end where the robot fits
  [[nodiscard]] Plan planBetween(const Costmap& costmap, const Eigen::Vector2d& start,
                                 const std::vector<Eigen::Vector2d>& exits,
                                 const Eigen::Vector2d& end) const;
  [[nodiscard]] std::optional<Eigen::Vector2d> nearestFit(const Costmap& costmap,
                                                          const Eigen::Vector2d& goal,
                                                          double tolerance) const;
  [[nodiscard]] Path improved(const Costmap& costmap, const Path& path) const;

  PlannerConfig config_;
  double radius_;
};

}  // namespace omega_slam::navigation
