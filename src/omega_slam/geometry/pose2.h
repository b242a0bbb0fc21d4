#pragma once

#include <Eigen/Core>
#include <vector>

namespace omega_slam::geometry {

/// A pose in the plane, an element of SE(2): `T_a_b`, the pose of frame b seen from frame a.
///
/// Poses compose so that inner names cancel: `T_map_base = T_map_odom * T_odom_base`.
/// The heading is kept in [-pi, pi) by every operation here.
struct Pose2 {
  double x{0.0};      ///< [m]
  double y{0.0};      ///< [m]
  double theta{0.0};  ///< [rad], counter-clockwise from the x axis

  [[nodiscard]] Eigen::Vector2d translation() const { return {x, y}; }
  [[nodiscard]] Eigen::Vector3d vector() const { return {x, y, theta}; }
  [[nodiscard]] Eigen::Matrix2d rotation() const;  ///< R_a_b
  [[nodiscard]] Pose2 inverse() const;             ///< `T_b_a`
  [[nodiscard]] bool isFinite() const;
  [[nodiscard]] static Pose2 fromVector(const Eigen::Vector3d& vector);
};

/// `T_a_c = T_a_b * T_b_c`
[[nodiscard]] Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c);

/// `p_a = T_a_b * p_b`
[[nodiscard]] Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b);

/// A pose with sine and cosine at hand, for many points: `p_a = T_a_b * p_b`, to the last digit as
/// the pose itself has it.
class PointTransform {
 public:
  explicit PointTransform(const Pose2& T_a_b);

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& p_b) const {
    return {x_ + cosine_ * p_b.x() - sine_ * p_b.y(), y_ + sine_ * p_b.x() + cosine_ * p_b.y()};
  }

 private:
  double x_;
  double y_;
  double cosine_;
  double sine_;
};

/// The pose of b seen from a, where both are seen from a common frame: `T_a_b = T_c_a^-1 * T_c_b`.
[[nodiscard]] Pose2 relativePose(const Pose2& T_c_a, const Pose2& T_c_b);

/// Between `start` (share 0) and `end` (share 1): position on the straight line, heading by the
/// shortest arc. A share outside of [0, 1] extrapolates.
[[nodiscard]] Pose2 interpolate(const Pose2& start, const Pose2& end, double share);

/// Distance of the origins [m].
[[nodiscard]] double distance(const Pose2& a, const Pose2& b);

/// A pose at a time.
struct StampedPose2 {
  double stamp{0.0};  ///< [s]
  Pose2 pose;
};

using Trajectory = std::vector<StampedPose2>;

}  // namespace omega_slam::geometry
