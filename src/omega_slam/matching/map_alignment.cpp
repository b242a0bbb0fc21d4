#include "omega_slam/matching/map_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

// Residuals are about 0.3; a prior of 1.5 cm, or 0.015 rad, so weighs (0.3 / 0.015)^2.
constexpr double kPrior = 400.0;        // [1/m^2], [1/rad^2]
constexpr double kLongestStep = 2.0;    // [cells]
constexpr double kLargestTurn = 0.2;    // [rad]
constexpr double kSmallestStep = 0.05;  // [cells] ends the search
constexpr double kSmallestTurn = 5e-3;  // [rad] likewise
constexpr double kSmallestGain = 1e-3;  // likewise: share of the cost that a step saves

/// Sums of v v^T, v being the derivatives of M by (x, y, theta), and 1 - M; in cells. Kept one by
/// one, in registers: half of the matrix is the other half.
struct Sums {
  double xx{0.0};
  double xy{0.0};
  double xt{0.0};
  double xr{0.0};
  double yy{0.0};
  double yt{0.0};
  double yr{0.0};
  double tt{0.0};
  double tr{0.0};
  double rr{0.0};

  void add(double x, double y, double t, double r) {
    xx += x * x;
    xy += x * y;
    xt += x * t;
    xr += x * r;
    yy += y * y;
    yt += y * t;
    yr += y * r;
    tt += t * t;
    tr += t * r;
    rr += r * r;
  }

  [[nodiscard]] Eigen::Matrix4d matrix() const {
    return (Eigen::Matrix4d() << xx, xy, xt, xr, xy, yy, yt, yr, xt, yt, tt, tr, xr, yr, tr, rr)
        .finished();
  }
};

/// @param scale cells per metre
MapLinearization inMetres(const Eigen::Matrix4d& sums, double scale) {
  const Eigen::Vector4d units(scale, scale, 1.0, 1.0);
  const Eigen::Matrix4d scaled = units.asDiagonal() * sums * units.asDiagonal();
  return {scaled(3, 3), scaled.topLeftCorner<3, 3>(), scaled.topRightCorner<3, 1>()};
}

}  // namespace

MapLinearization linearize(const LocalMap& map, std::size_t level, const Points& scan,
                           const Pose2& T_map_scan) {
  const ValueGrid& grid = map.grids()[level];
  const grid::GridGeometry& geometry = grid.geometry;
  const double scale = 1.0 / geometry.resolution;
  const Eigen::Matrix2d turn = scale * T_map_scan.rotation();
  // From here on in cells; whole numbers are their centres.
  const Eigen::Vector2d place =
      ((T_map_scan.translation() - geometry.origin) * scale).array() - 0.5;
  const double end_x = geometry.width - 1;
  const double end_y = geometry.height - 1;
  Sums sums;
  for (const Eigen::Vector2d& p_scan : scan) {
    const double arm_x = turn(0, 0) * p_scan.x() + turn(0, 1) * p_scan.y();
    const double arm_y = turn(1, 0) * p_scan.x() + turn(1, 1) * p_scan.y();
    const double x = place.x() + arm_x;
    const double y = place.y() + arm_y;
    if (!(x >= 0.0 && y >= 0.0 && x < end_x && y < end_y)) {
      sums.rr += 1.0;
      continue;
    }
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const double share_x = x - column;
    const double share_y = y - row;
    const std::uint8_t* const low = &grid.values[geometry.index({column, row})];
    const std::uint8_t* const high = low + geometry.width;
    const double below = low[0] + share_x * (low[1] - low[0]);
    const double above = high[0] + share_x * (high[1] - high[0]);
    const double slope_x = (low[1] - low[0]) * (1.0 - share_y) + (high[1] - high[0]) * share_y;
    constexpr double kUnit = 1.0 / ValueGrid::kMost;
    const double gx = kUnit * slope_x;
    const double gy = kUnit * (above - below);
    const double residual = 1.0 - kUnit * (below + share_y * (above - below));
    sums.add(gx, gy, gy * arm_x - gx * arm_y, residual);
  }
  return inMetres(sums.matrix(), scale);
}

namespace {

/// The search on one grid, held where it began.
class GridSearch {
 public:
  GridSearch(const LocalMap& map, std::size_t level, const Points& scan, const Pose2& start)
      : map_(map), level_(level), scan_(scan), start_(start), pose_(start) {}

  /// @return whether it came to rest
  bool run(int max_iterations) {
    MapLinearization here = linearize(map_, level_, scan_, pose_);
    Eigen::Vector3d step = stepFrom(here);
    for (int i = 0; i < max_iterations; ++i) {
      const Pose2 next = Pose2::fromVector(pose_.vector() + step);
      if (isSmall(step)) {
        pose_ = next;
        return true;
      }
      const MapLinearization there = linearize(map_, level_, scan_, next);
      const double gain = cost(here, pose_) - cost(there, next);
      if (gain < 0.0) {
        step *= 0.5;
        continue;
      }
      pose_ = next;
      if (gain < kSmallestGain * cost(here, pose_)) {
        return true;
      }
      here = there;
      step = stepFrom(here);
    }
    return false;
  }

  [[nodiscard]] const Pose2& pose() const { return pose_; }

 private:
  [[nodiscard]] Eigen::Vector3d offset(const Pose2& pose) const {
    return {pose.x - start_.x, pose.y - start_.y, relativePose(start_, pose).theta};
  }

  [[nodiscard]] double cost(const MapLinearization& at, const Pose2& pose) const {
    return at.squared_residuals + kPrior * offset(pose).squaredNorm();
  }

  [[nodiscard]] bool isSmall(const Eigen::Vector3d& step) const {
    return step.head<2>().norm() < kSmallestStep * resolution() &&
           std::abs(step[2]) < kSmallestTurn;
  }

  [[nodiscard]] double resolution() const { return map_.grids()[level_].geometry.resolution; }

  [[nodiscard]] Eigen::Vector3d stepFrom(const MapLinearization& here) const {
    const Eigen::Matrix3d matrix = here.hessian + kPrior * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = matrix.ldlt().solve(here.descent - kPrior * offset(pose_));
    const double excess = std::max(step.head<2>().norm() / (kLongestStep * resolution()),
                                   std::abs(step[2]) / kLargestTurn);
    return step / std::max(excess, 1.0);
  }

  const LocalMap& map_;
  const std::size_t level_;
  const Points& scan_;
  const Pose2 start_;
  Pose2 pose_;
};

}  // namespace

MapAlignment alignToMap(const LocalMap& map, const Points& scan, const Pose2& guess,
                        int max_iterations) {
  MapAlignment alignment{guess, false};
  for (std::size_t level = map.grids().size(); level-- > 0;) {
    GridSearch search(map, level, scan, alignment.T_map_scan);
    alignment.converged = search.run(max_iterations);
    alignment.T_map_scan = search.pose();
  }
  return alignment;
}

}  // namespace omega_slam::matching
