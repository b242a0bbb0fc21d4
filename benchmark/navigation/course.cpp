#include "navigation/course.h"

#include <memory>
#include <utility>

#include "omega_slam/grid/map_file.h"

namespace omega_slam::experiments {
namespace {

constexpr double kBeyond = 0.5;     // [m] beyond the map's edges
constexpr double kComfort = 0.35;   // [m] that people keep from walls
constexpr double kLeastWalk = 3.0;  // [m]

Eigen::Vector2d pointWithin(const grid::GridGeometry& geometry, double beyond,
                            std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double x = share(random);
  const double y = share(random);
  const Eigen::Vector2d size =
      geometry.resolution * Eigen::Vector2d(geometry.width, geometry.height);
  const Eigen::Vector2d rim(beyond, beyond);
  return geometry.origin - rim + Eigen::Vector2d(x, y).cwiseProduct(size + 2.0 * rim);
}

}  // namespace

navigation::Navigator Course::navigator(const navigation::NavigatorConfig& config) const {
  navigation::Navigator navigator(config, footprint);
  navigator.setMap(map);
  return navigator;
}

Eigen::Vector2d Course::placeToStand(const navigation::Costmap& costmap,
                                     std::mt19937_64& random) const {
  while (true) {
    const Eigen::Vector2d point = pointWithin(map.geometry, 0.0, random);
    if (costmap.isFree(point, footprint.circumscribed_radius + 0.05)) {
      return point;
    }
  }
}

Eigen::Vector2d Course::anywhere(std::mt19937_64& random) const {
  return pointWithin(map.geometry, kBeyond, random);
}

simulation::People Course::people(std::size_t count, std::mt19937_64& random) const {
  navigation::Costmap costmap{navigation::CostmapConfig{}};
  costmap.setMap(map);
  const navigation::GlobalPlanner planner({}, kComfort);
  std::vector<std::vector<Eigen::Vector2d>> routes;
  while (routes.size() < count) {
    const Eigen::Vector2d from = placeToStand(costmap, random);
    const Eigen::Vector2d to = placeToStand(costmap, random);
    const navigation::Plan plan = planner.plan(costmap, from, to);
    if (plan.found() && plan.leave == 0.0 && navigation::lengthOf(plan.path) >= kLeastWalk) {
      routes.push_back(plan.path);
    }
  }
  return {simulation::PeopleConfig{}, std::move(routes)};
}

Course loadCourse(const std::filesystem::path& map_file, const std::filesystem::path& urdf) {
  const grid::MapImage image = grid::loadMapImage(map_file);
  Course course;
  course.name = map_file.stem().string();
  course.world = std::make_shared<simulation::World>(simulation::World::fromImage(image));
  course.map = grid::toOccupancyGrid(image);
  course.footprint = navigation::readFootprint(urdf, "base_footprint");
  return course;
}

}  // namespace omega_slam::experiments
