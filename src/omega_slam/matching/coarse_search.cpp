#include "omega_slam/matching/coarse_search.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kCell = 0.1;   // [m] of the grid, and step of the search
constexpr double kTurn = 0.03;  // [rad] step of the search: 0.1 m at 3 m
constexpr std::size_t kMostPoints = 100;
constexpr double kFarthest = 30.0;  // [m] reference points farther from its origin are left out
// Share of points that a pose must gain for each metre or radian that it lies away from the guess.
constexpr double kPriorPerMetre = 0.15;
constexpr double kPriorPerRadian = 0.3;

/// Cells that a reference point lies in (weight 2) or beside (weight 1).
class PointGrid {
 public:
  explicit PointGrid(const Points& points) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : points) {
      if (point.norm() < kFarthest) {
        box.extend(point);
      }
    }
    if (box.isEmpty()) {
      return;
    }
    geometry_.resolution = kCell;
    geometry_.origin = box.min() - Eigen::Vector2d::Constant(2.0 * kCell);
    const Eigen::Vector2d size = (box.max() - geometry_.origin) / kCell;
    geometry_.width = static_cast<int>(size.x()) + 3;
    geometry_.height = static_cast<int>(size.y()) + 3;
    weights_.assign(geometry_.size(), 0);
    for (const Eigen::Vector2d& point : points) {
      if (point.norm() < kFarthest) {
        mark(geometry_.cellAt(point));
      }
    }
  }

  [[nodiscard]] int weightAt(const Eigen::Vector2d& point) const {
    const grid::Cell cell = geometry_.cellAt(point);
    return geometry_.contains(cell) ? weights_[geometry_.index(cell)] : 0;
  }

 private:
  void mark(const grid::Cell& center) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const std::size_t index = geometry_.index(center + grid::Cell(dx, dy));
        const std::uint8_t weight = dx == 0 && dy == 0 ? 2 : 1;
        weights_[index] = std::max(weights_[index], weight);
      }
    }
  }

  grid::GridGeometry geometry_;
  std::vector<std::uint8_t> weights_;
};

Points thinOut(const Points& points) {
  Points few;
  const std::size_t stride = points.size() / kMostPoints + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    few.push_back(points[i]);
  }
  return few;
}

}  // namespace

Pose2 searchCoarsely(const Points& reference, const Points& scan, const Pose2& guess,
                     const SearchWindow& window) {
  const PointGrid grid(reference);
  const Points points = thinOut(scan);
  const int steps = static_cast<int>(std::ceil(window.translation / kCell));
  const int turns = static_cast<int>(std::ceil(window.rotation / kTurn));
  const double full = 2.0 * static_cast<double>(points.size());
  Pose2 best = guess;
  double best_score = 0.0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const Pose2 turned{0.0, 0.0, guess.theta + turn * kTurn};
    Points rotated;
    for (const Eigen::Vector2d& p_scan : points) {
      rotated.push_back(turned * p_scan);
    }
    for (int iy = -steps; iy <= steps; ++iy) {
      for (int ix = -steps; ix <= steps; ++ix) {
        const Eigen::Vector2d offset(guess.x + ix * kCell, guess.y + iy * kCell);
        int hits = 0;
        for (const Eigen::Vector2d& p : rotated) {
          hits += grid.weightAt(p + offset);
        }
        const double score = hits / full - kPriorPerMetre * kCell * std::hypot(ix, iy) -
                             kPriorPerRadian * kTurn * std::abs(turn);
        if (score > best_score) {
          best_score = score;
          best = Pose2::fromVector({offset.x(), offset.y(), turned.theta});
        }
      }
    }
  }
  return best;
}

}  // namespace omega_slam::matching
