#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "omega_slam/matching/surface_model.h"
#include "omega_slam/matching/tiled_grid.h"
#include "omega_slam/matching/traced_surfaces.h"

namespace omega_slam::matching {

/// The distance field of surfaces: which of them is nearest to a place, in constant time. Each cell
/// of a grid keeps the sample that is nearest to its centre. The distance from the place to that
/// sample's patch is exact, so that it does not jump at the cells' borders. Immutable.
class SurfaceField {
 public:
  /// @param surfaces within a few hundred metres of the frame's origin
  /// @param reach [m] > 0: a place farther from all surfaces has no partner
  SurfaceField(TracedSurfaces surfaces, double reach);

  /// The surface near a place.
  /// @param facing normal of the surface that the place is on, seen from the same side: the other
  /// side of a thin wall is no partner, nor is a wall that crosses. Zero if unknown.
  /// @return its point is the nearest one or, where returns are sparse, on a line with it
  [[nodiscard]] std::optional<SurfaceModel::Partner> partnerOf(const Eigen::Vector2d& p_reference,
                                                               const Eigen::Vector2d& facing) const;

  [[nodiscard]] const TracedSurfaces& surfaces() const { return surfaces_; }

 private:
  struct Nearest {
    std::uint32_t sample{0};       // one more than its index; 0 for none
    float squared_distance{0.0F};  // [m^2] from the cell's centre
  };

  [[nodiscard]] grid::Cell cellOf(const Eigen::Vector2d& place) const;
  void paint(std::size_t sample);

  TracedSurfaces surfaces_;
  double reach_;
  double side_;    // [m] of a cell
  double radius_;  // [m] around a sample that is painted
  TiledGrid<Nearest> nearest_;
};

}  // namespace omega_slam::matching
