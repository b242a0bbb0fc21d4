#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/navigation/costmap.h"

namespace omega_slam::navigation {

/// Straight legs from point to point [m], in the map's frame.
using Path = std::vector<Eigen::Vector2d>;

[[nodiscard]] double lengthOf(const Path& path);  ///< [m]

/// A path and what has been travelled of it: for whoever drives along.
class PathMeasure {
 public:
  PathMeasure() = default;
  explicit PathMeasure(Path path);

  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] bool empty() const { return path_.empty(); }
  [[nodiscard]] double length() const { return along_.empty() ? 0.0 : along_.back(); }  ///< [m]

  /// The point so far along the path; at its ends beyond them. @param along [m]
  [[nodiscard]] Eigen::Vector2d at(double along) const;

  /// Where on the path a point is nearest.
  struct Projection {
    double along{0.0};     ///< [m] from the start
    double distance{0.0};  ///< [m] from the point
  };
  /// @param from, to [m] only this part of the path is looked at
  [[nodiscard]] Projection project(const Eigen::Vector2d& point, double from, double to) const;

 private:
  Path path_;
  std::vector<double> along_;  ///< [m] from the start to each point
};

/// What a metre costs, by how much room there is: 1 where there is plenty, 1 + weight where the
/// robot barely fits.
struct ClearanceCost {
  double radius{0.2};     ///< [m] of the robot
  double preferred{0.5};  ///< [m] clearance from which on room does not matter
  double weight{1.0};

  [[nodiscard]] double perMetre(double clearance) const;
  /// Integral along a straight line, in steps of half a cell of the map.
  [[nodiscard]] double ofLine(const Costmap& costmap, const Eigen::Vector2d& from,
                              const Eigen::Vector2d& to) const;
  [[nodiscard]] double ofPath(const Costmap& costmap, const Path& path) const;
};

/// The cheapest path that skips points of a path, by dynamic programming over points on it a
/// quarter of a metre apart, and legs of up to six metres. Ends stay, and what was free for the
/// radius of the cost stays so.
[[nodiscard]] Path shorten(const Path& path, const Costmap& costmap, const ClearanceCost& cost);

/// Rounds corners by quadratic Bezier curves, as wide as there is room for.
[[nodiscard]] Path roundCorners(const Path& path, const Costmap& costmap, double radius);

}  // namespace omega_slam::navigation
