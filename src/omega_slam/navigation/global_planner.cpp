#include "omega_slam/navigation/global_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/navigation/grid_search.h"
#include "omega_slam/navigation/sampling_planner.h"

namespace omega_slam::navigation {
namespace {

// Localisation and rounding may put a robot that touches a wall a little into it, but not so far
// that most of it is on the other side.
constexpr double kDeepest = 0.5;     // share of the radius that must be clear of obstacles
constexpr double kSlack = 0.03;      // [m] an exit may come nearer to an obstacle than the start is
constexpr double kLeaveCost = 10.0;  // of a metre on the way out: the nearest exits are the best
constexpr double kFarthest = 1e6;    // [m] farther away, cells can't be counted

/// Cell centres about a point, the nearest first.
std::vector<Eigen::Vector2d> centersAbout(const grid::GridGeometry& geometry,
                                          const Eigen::Vector2d& point, double distance) {
  const Eigen::Vector2d reach(distance, distance);
  const grid::Cell low = geometry.cellAt(point - reach);
  const grid::Cell high = geometry.cellAt(point + reach);
  std::vector<Eigen::Vector2d> centers;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const Eigen::Vector2d center = geometry.center({column, row});
      if (geometry.contains({column, row}) && (center - point).norm() <= distance) {
        centers.push_back(center);
      }
    }
  }
  std::stable_sort(centers.begin(), centers.end(), [&](const auto& a, const auto& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
  return centers;
}

Plan refusal(PlanStatus status, std::string reason) {
  Plan plan;
  plan.status = status;
  plan.reason = std::move(reason);
  return plan;
}

std::string text(const Eigen::Vector2d& point) {
  return fmt::format("({:.2f}, {:.2f})", point.x(), point.y());
}

bool isCountable(const Eigen::Vector2d& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() < kFarthest;
}

}  // namespace

std::vector<std::string> plannerNames() {
  std::vector<std::string> names{"grid"};
  names.insert(names.end(), samplingPlannerNames().begin(), samplingPlannerNames().end());
  return names;
}

std::vector<std::string> PlannerConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("max_cells", max_cells, 1.0);
  violations.requireAtLeast("time_limit", time_limit, 0.0);
  violations.requireAtLeast("iterations", iterations, 1.0);
  violations.requireAtLeast("seed", seed, 1.0);
  violations.requireAtLeast("preferred_clearance", preferred_clearance, 0.0);
  violations.requireAtLeast("clearance_weight", clearance_weight, 0.0);
  violations.requireWithin("goal_tolerance", goal_tolerance, 0.0, 10.0);
  violations.requireWithin("leave_distance", leave_distance, 0.0, 10.0);
  std::vector<std::string> sentences = violations.sentences();
  const std::vector<std::string> names = plannerNames();
  if (std::find(names.begin(), names.end(), planner) == names.end()) {
    sentences.push_back("planner is \"" + planner + "\", which is none.");
  }
  return sentences;
}

GlobalPlanner::GlobalPlanner(const PlannerConfig& config, double radius)
    : config_(config), radius_(radius) {
  std::vector<std::string> sentences = config_.validate();
  geometry::Violations violations;
  violations.requireWithin("radius", radius, 0.01, 10.0);
  sentences.insert(sentences.end(), violations.sentences().begin(), violations.sentences().end());
  geometry::throwIfAny(sentences);
}

ClearanceCost GlobalPlanner::cost() const {
  return {radius_, std::max(config_.preferred_clearance, radius_ + 1e-3), config_.clearance_weight};
}

Plan GlobalPlanner::plan(const Costmap& costmap, const Eigen::Vector2d& start,
                         const Eigen::Vector2d& goal) const {
  return plan(costmap, start, goal, config_.goal_tolerance);
}

Plan GlobalPlanner::plan(const Costmap& costmap, const Eigen::Vector2d& start,
                         const Eigen::Vector2d& goal, double goal_tolerance) const {
  if (!costmap.hasMap()) {
    return refusal(PlanStatus::kNoMap, "There is no map.");
  }
  if (!isCountable(start) || !isCountable(goal)) {
    return refusal(PlanStatus::kNotFinite, "Start and goal must be finite.");
  }
  Plan plan = planOnce(costmap, start, goal, goal_tolerance);
  if (plan.status == PlanStatus::kStartBlocked || plan.status == PlanStatus::kGoalTooNarrow ||
      plan.status == PlanStatus::kNoWay || plan.status == PlanStatus::kUndecided) {
    Costmap map_alone = costmap;
    map_alone.forgetSeen();
    const Plan other = planOnce(map_alone, start, goal, goal_tolerance);
    plan.passing = other.found();
    plan.looked += other.looked;
  }
  return plan;
}

Plan GlobalPlanner::planOnce(const Costmap& costmap, const Eigen::Vector2d& start,
                             const Eigen::Vector2d& goal, double goal_tolerance) const {
  const grid::GridGeometry& geometry = costmap.geometry();
  const grid::Cell goal_cell = geometry.cellAt(goal);
  if (!geometry.contains(geometry.cellAt(start))) {
    return refusal(PlanStatus::kStartOutside, "The robot is outside of the map.");
  }
  if (!geometry.contains(goal_cell)) {
    return refusal(PlanStatus::kGoalOutside, "The goal " + text(goal) + " is outside of the map.");
  }
  if (costmap.isOccupied(goal_cell)) {
    return refusal(PlanStatus::kGoalOccupied, "The goal " + text(goal) + " is in an obstacle.");
  }
  if (costmap.isUnknown(goal_cell)) {
    return refusal(PlanStatus::kGoalUnknown,
                   "The goal " + text(goal) + " is where the map is unknown.");
  }
  const auto end = nearestFit(costmap, goal, goal_tolerance);
  if (!end) {
    return refusal(PlanStatus::kGoalTooNarrow, "The robot does not fit at " + text(goal) + ".");
  }
  const auto exits = exitsFrom(costmap, start);
  if (exits.empty()) {
    return refusal(PlanStatus::kStartBlocked,
                   "The robot cannot leave " + text(start) + ", where it does not fit.");
  }
  return planBetween(costmap, start, exits, *end);
}

Plan GlobalPlanner::planBetween(const Costmap& costmap, const Eigen::Vector2d& start,
                                const std::vector<Eigen::Vector2d>& exits,
                                const Eigen::Vector2d& end) const {
  const GridSearch search(costmap, cost(), static_cast<std::size_t>(config_.max_cells));
  std::vector<Departure> departures;
  for (const Eigen::Vector2d& exit : exits) {
    departures.push_back({exit, kLeaveCost * (exit - start).norm()});
  }
  const bool fits = exits.front() == start;
  const SearchOutcome way = fits ? search.find(start, end) : search.findFromAny(departures, end);
  Plan plan;
  if (!way.path) {
    plan = way.is_spent ? refusal(PlanStatus::kUndecided,
                                  fmt::format("No way from {} to {} was found among {} cells.",
                                              text(start), text(end), way.looked))
                        : refusal(PlanStatus::kNoWay,
                                  "There is no way from " + text(start) + " to " + text(end) + ".");
    plan.looked = way.looked;
    return plan;
  }
  plan.status = PlanStatus::kFound;
  plan.looked = way.looked;
  plan.path = improved(costmap, *way.path);
  plan.leave = (plan.path.front() - start).norm();
  if (plan.leave > 0.0) {
    plan.path.insert(plan.path.begin(), start);
  }
  return plan;
}

std::optional<Eigen::Vector2d> GlobalPlanner::nearestFit(const Costmap& costmap,
                                                         const Eigen::Vector2d& goal,
                                                         double tolerance) const {
  const GridSearch search(costmap, cost());
  const grid::GridGeometry& geometry = costmap.geometry();
  if (costmap.isFree(goal, radius_) && search.isPassable(geometry.cellAt(goal))) {
    return goal;
  }
  for (const Eigen::Vector2d& center :
       centersAbout(geometry, goal, std::max(tolerance, geometry.resolution))) {
    if (search.isPassable(geometry.cellAt(center))) {
      // Where the robot fits at the very goal, it only has to get there from the cell beside it.
      const bool beside = costmap.isFree(goal, center, radius_);
      if (beside || (center - goal).norm() <= tolerance) {
        return beside ? goal : center;
      }
    }
  }
  return std::nullopt;
}

std::vector<Eigen::Vector2d> GlobalPlanner::exitsFrom(const Costmap& costmap,
                                                      const Eigen::Vector2d& start) const {
  const GridSearch search(costmap, cost());
  const grid::GridGeometry& geometry = costmap.geometry();
  if (costmap.isFree(start, radius_) && search.isPassable(geometry.cellAt(start))) {
    return {start};
  }
  std::vector<Eigen::Vector2d> exits;
  const double room = costmap.solidClearance(start);
  if (room < kDeepest * radius_ - geometry.resolution) {
    return exits;
  }
  const double needed = std::min(room, radius_) - kSlack;
  for (const Eigen::Vector2d& center : centersAbout(geometry, start, config_.leave_distance)) {
    if (!search.isPassable(geometry.cellAt(center))) {
      continue;
    }
    const double length = (center - start).norm();
    const int steps = static_cast<int>(std::ceil(2.0 * length / geometry.resolution));
    bool leads_out = true;
    for (int i = 1; i < steps && leads_out; ++i) {
      const Eigen::Vector2d point = start + (center - start) * (static_cast<double>(i) / steps);
      leads_out = costmap.solidClearance(point) >= needed;
    }
    if (leads_out) {
      exits.push_back(center);
    }
  }
  return exits;
}

Path GlobalPlanner::improved(const Costmap& costmap, const Path& path) const {
  const ClearanceCost cost = this->cost();
  Path best = shorten(path, costmap, cost);
  if (config_.planner != "grid") {
    const auto sampled = samplePath(config_.planner, costmap, cost, best,
                                    {config_.iterations, config_.time_limit, config_.seed});
    if (sampled) {
      Path other = shorten(*sampled, costmap, cost);
      if (cost.ofPath(costmap, other) < cost.ofPath(costmap, best)) {
        best = std::move(other);
      }
    }
  }
  return roundCorners(best, costmap, radius_);
}

}  // namespace omega_slam::navigation
