#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "omega_slam/simulation/surroundings.h"

namespace omega_slam::simulation {

struct PeopleConfig {
  double speed{0.8};           ///< [m/s]
  double radius{0.2};          ///< [m] of what a laser sees of them
  double personal_space{0.3};  ///< [m] nobody walks nearer to a robot than this
  double patience{4.0};        ///< [s] that they wait for a robot before they turn round

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// People who walk up and down, each along a route of their own. They look at no wall: a route must
/// be free. Before a robot they stop, and after a while they turn round: whoever touches has driven
/// into them. No randomness: the same steps bring the same people to the same places.
class People {
 public:
  People() = default;  ///< nobody

  /// @param routes [m] in the world, of two points or more; everybody begins at the first point
  /// @throws std::invalid_argument if the configuration is not valid, or a route is none
  People(const PeopleConfig& config, std::vector<std::vector<Eigen::Vector2d>> routes);

  /// Lets `dt` > 0 [s] pass. @param robot where one is, of that radius
  void step(double dt, const Disc& robot);

  [[nodiscard]] const std::vector<Disc>& discs() const { return discs_; }

 private:
  struct Walker {
    std::vector<Eigen::Vector2d> route;
    std::size_t next{1};  ///< point of the route that is walked to
    bool backwards{false};
    double waited{0.0};  ///< [s]
  };

  void walk(Walker& walker, Disc& disc, double dt, const Disc& robot) const;
  static void turnRound(Walker& walker);

  PeopleConfig config_;
  std::vector<Walker> walkers_;
  std::vector<Disc> discs_;
};

}  // namespace omega_slam::simulation
