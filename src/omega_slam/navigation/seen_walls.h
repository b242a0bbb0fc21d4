#pragma once

#include <Eigen/Core>
#include <vector>

namespace omega_slam::navigation {

/// Where the map's obstacles near the robot are seen to begin. Maps are drawn a few centimetres
/// off, and in cells; a robot that passes a table leg by less than that must go by what it sees.
/// Points are remembered for a moment: the leg beside it is too near for the laser, or behind it.
/// Times are the caller's. Not thread-safe.
class SeenWalls {
 public:
  /// @param points [m] in the map; @param robot [m] farther from it, nothing is remembered
  void see(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& robot, double stamp);
  void forget() { marks_.clear(); }

  /// [m] to the nearest, which beam errors have made too near, as a rule; infinity without any.
  [[nodiscard]] double distance(const Eigen::Vector2d& point) const;

 private:
  struct Mark {
    Eigen::Vector2d point;  ///< [m] in the map
    double stamp;           ///< [s] when it was seen last
  };
  std::vector<Mark> marks_;
};

}  // namespace omega_slam::navigation
