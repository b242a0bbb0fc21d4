#include "navigation/queries.h"

#include <algorithm>
#include <cmath>

#include "experiments/cpu_timer.h"
#include "omega_slam/navigation/grid_search.h"

namespace omega_slam::experiments {
namespace {

/// From a segment to a square: both are convex, so the least distance is 0, or has a corner of the
/// square or an end of the segment at one of its ends.
double distanceToSquare(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                        const Eigen::Vector2d& corner, double edge) {
  const Eigen::Vector2d far = corner + Eigen::Vector2d(edge, edge);
  const auto ofPoint = [&](const Eigen::Vector2d& point) {
    return (point - point.cwiseMax(corner).cwiseMin(far)).norm();
  };
  double least = std::min(ofPoint(from), ofPoint(to));
  const Eigen::Vector2d way = to - from;
  for (const Eigen::Vector2d& vertex :
       {corner, far, Eigen::Vector2d(corner.x(), far.y()), Eigen::Vector2d(far.x(), corner.y())}) {
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp(way.dot(vertex - from) / square, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d nearest = from + share * way;
    least = std::min({least, (vertex - nearest).norm(), ofPoint(nearest)});
  }
  return least;
}

}  // namespace

double leastClearance(const grid::OccupancyGrid& map, const navigation::Path& path, double reach) {
  const grid::GridGeometry& geometry = map.geometry;
  double least = reach;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d rim(reach, reach);
    const grid::Cell low = geometry.cellAt(path[i].cwiseMin(path[i + 1]) - rim);
    const grid::Cell high = geometry.cellAt(path[i].cwiseMax(path[i + 1]) + rim);
    for (int row = low.y(); row <= high.y(); ++row) {
      for (int column = low.x(); column <= high.x(); ++column) {
        const grid::Cell cell(column, row);
        if (geometry.contains(cell) && map.at(cell) == grid::kFree) {
          continue;
        }
        const Eigen::Vector2d corner = geometry.origin + geometry.resolution * cell.cast<double>();
        least =
            std::min(least, distanceToSquare(path[i], path[i + 1], corner, geometry.resolution));
      }
    }
  }
  return least;
}

std::vector<QueryResult> askForWays(const Course& course, const std::string& planner,
                                    std::size_t queries, std::uint64_t seed) {
  navigation::NavigatorConfig config;
  config.planner.planner = planner;
  const navigation::Navigator navigator = course.navigator(config);
  navigation::ClearanceCost shortest = navigator.planner().cost();
  shortest.weight = 0.0;
  const navigation::GridSearch oracle(navigator.costmap(), shortest);
  std::mt19937_64 random(seed);
  std::vector<QueryResult> results;
  while (results.size() < queries) {
    const Eigen::Vector2d from = course.placeToStand(navigator.costmap(), random);
    const Eigen::Vector2d to = course.placeToStand(navigator.costmap(), random);
    QueryResult result;
    const CpuTimer timer;
    const navigation::Plan plan = navigator.plan(from, to);
    result.milliseconds = 1e3 * timer.seconds();
    const auto way = oracle.find(from, to).path;
    result.has_way = way.has_value();
    result.shortest = way ? navigation::lengthOf(*way) : 0.0;
    result.found = plan.found();
    if (plan.found()) {
      result.length = navigation::lengthOf(plan.path);
      result.least_clearance = leastClearance(course.map, plan.path, 0.5);
    }
    results.push_back(result);
  }
  return results;
}

}  // namespace omega_slam::experiments
