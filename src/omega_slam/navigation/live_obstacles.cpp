#include "omega_slam/navigation/live_obstacles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::navigation {
namespace {

constexpr double kSoon = 0.1;  // [s] marks that would be dropped before the next scan are dropped

}  // namespace

LiveObstacles::LiveObstacles(double resolution, double reach) : reach_(reach) {
  geometry_.resolution = resolution;
  geometry_ = squareAbout({0.0, 0.0});
  forget();
}

grid::GridGeometry LiveObstacles::squareAbout(const Eigen::Vector2d& point) const {
  grid::GridGeometry square = geometry_;
  const int half = static_cast<int>(std::ceil(reach_ / square.resolution));
  square.width = square.height = 2 * half + 1;
  // On a lattice that stands still, so that marks move from square to square unchanged.
  const Eigen::Vector2d cell(std::floor(point.x() / square.resolution),
                             std::floor(point.y() / square.resolution));
  square.origin = square.resolution * (cell - Eigen::Vector2d(half, half));
  return square;
}

void LiveObstacles::center(const Eigen::Vector2d& point) {
  const Eigen::Vector2d middle = geometry_.center({geometry_.width / 2, geometry_.height / 2});
  if ((point - middle).cwiseAbs().maxCoeff() < 0.25 * reach_) {
    return;
  }
  const grid::GridGeometry square = squareAbout(point);
  std::vector<double> until(square.size(), 0.0);
  const grid::Cell shift = square.cellAt(geometry_.center({0, 0}));
  for (int row = 0; row < geometry_.height; ++row) {
    for (int column = 0; column < geometry_.width; ++column) {
      const grid::Cell cell = shift + grid::Cell(column, row);
      if (square.contains(cell)) {
        until[square.index(cell)] = until_[geometry_.index({column, row})];
      }
    }
  }
  geometry_ = square;
  until_ = std::move(until);
  rebuild();
}

Eigen::Vector2d LiveObstacles::clipped(const Eigen::Vector2d& origin,
                                       const Eigen::Vector2d& end) const {
  const Eigen::Vector2d beam = end - origin;
  const double length = beam.norm();
  const double farthest = 2.0 * reach_;
  return length <= farthest ? end : Eigen::Vector2d(origin + beam * (farthest / length));
}

void LiveObstacles::clearAlong(const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
  grid::traverseRay(geometry_, origin, clipped(origin, end), [&](const grid::Cell& cell) {
    if (geometry_.contains(cell)) {
      until_[geometry_.index(cell)] = 0.0;
    }
  });
}

void LiveObstacles::see(const Sighting& sighting, double memory) {
  if (!sighting.origin.allFinite()) {
    return;
  }
  (void)drop(sighting.stamp + kSoon);  // with what is seen, so that distances are reckoned once
  for (const auto* ends : {&sighting.returns, &sighting.clear}) {
    for (const Eigen::Vector2d& end : *ends) {
      if (end.allFinite()) {
        clearAlong(sighting.origin, end);
      }
    }
  }
  // After all beams are drawn: what one has hit, its neighbour must not clear.
  for (const Eigen::Vector2d& point : sighting.returns) {
    if (point.allFinite() &&
        geometry_.contains(geometry_.cellAt(clipped(sighting.origin, point))) &&
        clipped(sighting.origin, point) == point) {
      until_[geometry_.index(geometry_.cellAt(point))] = sighting.stamp + memory;
    }
  }
  rebuild();
}

bool LiveObstacles::drop(double now) {
  bool changed = false;
  for (double& until : until_) {
    if (until > 0.0 && until <= now) {
      until = 0.0;
      changed = true;
    }
  }
  return changed;
}

void LiveObstacles::expire(double now) {
  if (drop(now)) {
    rebuild();
  }
}

void LiveObstacles::forget() {
  until_.assign(geometry_.size(), 0.0);
  rebuild();
}

void LiveObstacles::rebuild() {
  std::vector<std::uint8_t> obstacles(geometry_.size());
  std::transform(until_.begin(), until_.end(), obstacles.begin(),
                 [](double until) { return static_cast<std::uint8_t>(until > 0.0 ? 1 : 0); });
  field_ = grid::DistanceField(geometry_, std::move(obstacles), grid::Outside::kOpen);
}

}  // namespace omega_slam::navigation
