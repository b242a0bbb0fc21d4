#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "omega_slam/matching/point_index.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// The line through the points around a place.
struct Surface {
  Eigen::Vector2d normal{0.0, 0.0};  ///< unit; zero where the points form no line
  double slope_variance{0.0};        ///< of the normal's direction [rad^2]

  [[nodiscard]] bool isLine() const { return !normal.isZero(); }
};

/// The line that fits the points best; none (a zero normal) for fewer than three, or a heap.
[[nodiscard]] Surface fitSurface(const Points& points,
                                 const std::vector<PointIndex::Neighbour>& members);

/// The points of a reference as the surfaces that they were measured on. A surface is fitted when
/// it is first asked for. The points must outlive the model. Not thread-safe.
class SurfaceModel {
 public:
  explicit SurfaceModel(const Points& reference);

  struct Partner {
    Eigen::Vector2d point;  ///< [m] of the reference
    Surface surface;        ///< around it
  };

  /// The reference point nearest to a place, none if it is farther than `reach` [m].
  [[nodiscard]] std::optional<Partner> partnerOf(const Eigen::Vector2d& p_reference, double reach);

 private:
  const Points& reference_;
  PointIndex index_;
  std::vector<std::optional<Surface>> surfaces_;
  std::vector<PointIndex::Neighbour> neighbours_;  // kept, so as not to allocate for each point
};

}  // namespace omega_slam::matching
