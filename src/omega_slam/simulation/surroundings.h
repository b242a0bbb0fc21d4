#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "omega_slam/simulation/world.h"

namespace omega_slam::simulation {

/// Something round that stands in the world, and may stand elsewhere the next moment.
struct Disc {
  Eigen::Vector2d center{0.0, 0.0};  ///< [m], in the world
  double radius{0.2};                ///< [m]
};

/// What a robot meets at one moment: the world, and who walks in it. A view of both, which must
/// outlive it.
class Surroundings {
 public:
  /// Of the world alone; implicit, for where nobody walks.
  Surroundings(const World& world) : world_(world) {}  // NOLINT(google-explicit-constructor)
  Surroundings(const World& world, const std::vector<Disc>& discs)
      : world_(world), discs_(&discs) {}

  /// As World::castRay(); discs stop light as walls do.
  [[nodiscard]] std::optional<RayHit> castRay(const Eigen::Vector2d& origin, double angle,
                                              double max_range) const;

  /// As World::nearestObstacle(); discs are obstacles.
  [[nodiscard]] std::optional<Eigen::Vector2d> nearestObstacle(const Eigen::Vector2d& center,
                                                               double radius) const;

 private:
  const World& world_;
  const std::vector<Disc>* discs_{nullptr};
};

}  // namespace omega_slam::simulation
