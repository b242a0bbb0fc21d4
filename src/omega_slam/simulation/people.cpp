#include "omega_slam/simulation/people.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {

std::vector<std::string> PeopleConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("speed", speed, 0.0);
  violations.requireAbove("radius", radius, 0.0);
  violations.requireAtLeast("personal_space", personal_space, 0.0);
  violations.requireAtLeast("patience", patience, 0.0);
  return violations.sentences();
}

People::People(const PeopleConfig& config, std::vector<std::vector<Eigen::Vector2d>> routes)
    : config_(config) {
  geometry::throwIfAny(config_.validate());
  for (std::vector<Eigen::Vector2d>& route : routes) {
    const bool finite = std::all_of(route.begin(), route.end(),
                                    [](const Eigen::Vector2d& point) { return point.allFinite(); });
    if (route.size() < 2 || !finite) {
      throw std::invalid_argument("A person's route needs two finite points or more.");
    }
    discs_.push_back({route.front(), config_.radius});
    walkers_.push_back({std::move(route)});
  }
}

void People::step(double dt, const Disc& robot) {
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    walk(walkers_[i], discs_[i], dt, robot);
  }
}

void People::walk(Walker& walker, Disc& disc, double dt, const Disc& robot) const {
  const Eigen::Vector2d way = walker.route[walker.next] - disc.center;
  const double step = std::min(config_.speed * dt, way.norm());
  const Eigen::Vector2d there = disc.center + way.normalized() * step;
  const double near = disc.radius + robot.radius + config_.personal_space;
  const double distance = (there - robot.center).norm();
  // Whoever is near already may still walk away.
  if (distance < near && distance < (disc.center - robot.center).norm()) {
    walker.waited += dt;
    if (walker.waited >= config_.patience) {
      turnRound(walker);
    }
    return;
  }
  walker.waited = 0.0;
  disc.center = there;
  if (step < way.norm()) {
    return;
  }
  const bool at_end = walker.backwards ? walker.next == 0 : walker.next + 1 == walker.route.size();
  if (at_end) {
    walker.backwards = !walker.backwards;
  }
  walker.next += walker.backwards ? -1 : 1;
}

void People::turnRound(Walker& walker) {
  walker.waited = 0.0;
  walker.backwards = !walker.backwards;
  const bool leaves = walker.backwards ? walker.next > 0 : walker.next + 1 < walker.route.size();
  if (leaves) {
    walker.next += walker.backwards ? -1 : 1;
  }
}

}  // namespace omega_slam::simulation
