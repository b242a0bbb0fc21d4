#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Nearest neighbours among points of the plane.
///
/// The points are sorted by the cells of a square grid that is wrapped around like a torus: cells
/// that lie a whole turn apart share a bucket. No memory is spent on the empty plane between far
/// walls, nothing is hashed, and a bucket's strangers are found out by their distance. Built in
/// O(points); a query looks at the cells within its answer's distance only, which for the points of
/// a laser beats a tree by far.
class PointIndex {
 public:
  /// @param points finite, outlive the index; those beyond 35 km of the origin are found as well,
  /// but slowly
  explicit PointIndex(const Points& points);

  struct Neighbour {
    std::size_t index{0};          ///< of the point among those given
    double squared_distance{0.0};  ///< [m^2]
  };

  struct Nearest {
    std::size_t index{0};          ///< of the point among those given
    double squared_distance{0.0};  ///< [m^2]
    double squared_next{0.0};      ///< [m^2] all others are as far away as this, or farther
  };

  /// The nearest point, none if it is farther than `reach` [m].
  /// @param likely indices of points that are likely to be near, as the last answer where queries
  /// follow a sweep: they and those after them are looked at first, and leave fewer others to look
  /// at
  [[nodiscard]] std::optional<Nearest> nearest(const Eigen::Vector2d& query, double reach,
                                               const std::array<std::size_t, 2>& likely = {}) const;

  /// All points within a radius [m], in no particular order but always the same.
  void within(const Eigen::Vector2d& query, double radius,
              std::vector<Neighbour>& neighbours) const;

 private:
  struct Cell {
    std::int32_t x;
    std::int32_t y;
  };
  struct Entry {
    Eigen::Vector2d point;
    std::size_t index;
  };
  [[nodiscard]] static Cell cellOf(const Eigen::Vector2d& point);
  [[nodiscard]] static std::size_t bucketOf(std::int32_t x, std::int32_t y);
  template <class Visitor>
  void visitRow(std::int32_t y, std::int32_t first_x, std::int32_t last_x, Visitor visit) const;
  template <class Visitor>
  [[nodiscard]] double searchRings(const Eigen::Vector2d& query, std::int32_t rings,
                                   const double& smallest, Visitor visit) const;

  const Points& points_;
  std::vector<std::uint32_t> starts_;  // of each bucket's entries, and the end
  std::vector<Entry> entries_;         // sorted by bucket
};

}  // namespace omega_slam::matching
