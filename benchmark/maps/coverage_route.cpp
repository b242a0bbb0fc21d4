#include "maps/coverage_route.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "maps/floor_plan.h"
#include "omega_slam/evaluation/cell_mask.h"

namespace omega_slam::experiments {
namespace {

using grid::Cell;

constexpr double kLookingAgain = 0.2;   // [m] driven between two looks
constexpr double kOverhead = 1.0;       // [m] a way costs so much more: near trifles can wait
constexpr double kShortcutShare = 0.9;  // a straight line may come so much closer to obstacles,
constexpr double kShortcutRoom =
    0.42;  // [m] and where there is so much room, it is straight anyway

/// A place to look from.
struct Viewpoint {
  Cell cell;
  std::vector<std::size_t> visible;
};

/// What of the building was seen so far.
class Sight {
 public:
  Sight(const FloorPlan& plan, const evaluation::CellMask& reachable) {
    wanted_.resize(plan.geometry().size(), 0);
    evaluation::forEachCell(plan.geometry(), [&](const Cell& cell) {
      wanted_[plan.geometry().index(cell)] = reachable.at(cell) ? 1 : 0;
    });
    all_ = count();
  }

  [[nodiscard]] std::size_t gain(const std::vector<std::size_t>& visible) const {
    return static_cast<std::size_t>(std::count_if(
        visible.begin(), visible.end(), [this](std::size_t index) { return wanted_[index] != 0; }));
  }
  void see(const std::vector<std::size_t>& visible) {
    for (const std::size_t index : visible) {
      wanted_[index] = 0;
    }
  }
  [[nodiscard]] double share() const {
    return 1.0 - static_cast<double>(count()) / static_cast<double>(std::max<std::size_t>(all_, 1));
  }

 private:
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::count(wanted_.begin(), wanted_.end(), 1));
  }

  std::vector<char> wanted_;
  std::size_t all_{0};
};

std::vector<Viewpoint> viewpointsOf(const FloorPlan& plan, const CoverageConfig& config) {
  const int stride = std::max(1, static_cast<int>(config.spacing / plan.geometry().resolution));
  std::vector<Viewpoint> viewpoints;
  for (int y = 0; y < plan.geometry().height; y += stride) {
    for (int x = 0; x < plan.geometry().width; x += stride) {
      if (const Cell cell(x, y); plan.fits(cell)) {
        viewpoints.push_back({cell, plan.visibleFrom(cell, config.view_range, 0.0, geometry::kPi)});
      }
    }
  }
  return viewpoints;
}

/// The one with most to see for the way to it; none if that is less than the least.
std::optional<std::size_t> choose(const std::vector<Viewpoint>& viewpoints, const Ways& ways,
                                  const Sight& sight, double least) {
  std::optional<std::size_t> best;
  double best_worth = 0.0;
  for (std::size_t k = 0; k < viewpoints.size(); ++k) {
    const auto cost = ways.cost(viewpoints[k].cell);
    const auto gain = static_cast<double>(sight.gain(viewpoints[k].visible));
    if (cost && gain >= least && gain / (*cost + kOverhead) > best_worth) {
      best = k;
      best_worth = gain / (*cost + kOverhead);
    }
  }
  return best;
}

/// Corners of a path, without those that a straight line may leave out.
std::vector<Cell> straighten(const FloorPlan& plan, const std::vector<Cell>& path) {
  std::vector<Cell> corners{path.front()};
  std::size_t anchor = 0;
  while (anchor + 1 < path.size()) {
    std::size_t last = anchor + 1;
    double room = plan.clearance(path[anchor]);
    for (std::size_t k = anchor + 1; k < path.size(); ++k) {
      room = std::min(room, plan.clearance(path[k]));
      if (plan.clearanceAlong(path[anchor], path[k]) >=
          std::min(kShortcutRoom, kShortcutShare * room)) {
        last = k;
      }
    }
    anchor = last;
    corners.push_back(path[anchor]);
  }
  return corners;
}

/// Sees along a straight leg, looking forwards.
void lookAlong(const FloorPlan& plan, const Cell& from, const Cell& to,
               const CoverageConfig& config, Sight& sight) {
  const Eigen::Vector2d start = plan.geometry().center(from);
  const Eigen::Vector2d leg = plan.geometry().center(to) - start;
  const double heading = std::atan2(leg.y(), leg.x());
  const int looks = static_cast<int>(std::ceil(leg.norm() / kLookingAgain));
  for (int k = 0; k <= looks; ++k) {
    const Eigen::Vector2d eye = start + leg * (looks == 0 ? 0.0 : static_cast<double>(k) / looks);
    sight.see(plan.visibleFrom(plan.geometry().cellAt(eye), config.view_range, heading,
                               0.5 * config.field_of_view));
  }
}

/// The robot at a place on its route.
class Traveller {
 public:
  Traveller(const FloorPlan& plan, const Cell& start) : plan_(plan), corners_{start} {}

  [[nodiscard]] const Cell& place() const { return corners_.back(); }
  [[nodiscard]] const std::vector<Cell>& corners() const { return corners_; }

  void go(const std::vector<Cell>& path, const CoverageConfig& config, Sight& sight) {
    const std::vector<Cell> corners = straighten(plan_, path);
    for (std::size_t k = 1; k < corners.size(); ++k) {
      lookAlong(plan_, corners[k - 1], corners[k], config, sight);
      corners_.push_back(corners[k]);
    }
  }

 private:
  const FloorPlan& plan_;
  std::vector<Cell> corners_;
};

}  // namespace

CoverageRoute planCoverage(const grid::OccupancyGrid& map, const Eigen::Vector2d& near,
                           const CoverageConfig& config) {
  const FloorPlan plan(map, config.room);
  const Cell home = plan.nearestFit(near);
  Sight sight(plan, evaluation::reachableFrom(map, map.geometry.center(home)));
  std::vector<Viewpoint> viewpoints = viewpointsOf(plan, config);
  const double least = config.least_gain / std::pow(map.geometry.resolution, 2);
  Traveller robot(plan, home);
  // Each viewpoint is visited once at most, so there is an end to it.
  while (true) {
    const Ways ways(plan, robot.place());
    const auto next = choose(viewpoints, ways, sight, least);
    if (!next) {
      robot.go(ways.path(home), config, sight);
      break;
    }
    robot.go(ways.path(viewpoints[*next].cell), config, sight);
    viewpoints.erase(viewpoints.begin() + static_cast<std::ptrdiff_t>(*next));
  }
  CoverageRoute route;
  for (const Cell& corner : robot.corners()) {
    route.waypoints.push_back(map.geometry.center(corner));
  }
  route.seen = sight.share();
  route.start = route.waypoints.front();
  return route;
}

}  // namespace omega_slam::experiments
