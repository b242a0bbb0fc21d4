#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Nearest neighbours among points of the plane, by a kd-tree. The points must outlive the index.
class PointIndex {
 public:
  explicit PointIndex(const Points& points);
  ~PointIndex();
  PointIndex(const PointIndex&) = delete;
  PointIndex& operator=(const PointIndex&) = delete;

  struct Neighbour {
    std::size_t index{0};
    double squared_distance{0.0};  ///< [m^2]
  };

  /// Up to `count` nearest points, nearest first; fewer only if there are fewer points.
  void nearest(const Eigen::Vector2d& query, std::size_t count,
               std::vector<Neighbour>& neighbours) const;

  /// All points within a radius [m], in no particular order.
  void within(const Eigen::Vector2d& query, double radius,
              std::vector<Neighbour>& neighbours) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace omega_slam::matching
