#include "omega_slam/geometry/pose2.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::geometry {

Eigen::Matrix2d Pose2::rotation() const {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  return {-c * x - s * y, s * x - c * y, normalizeAngle(-theta)};
}

bool Pose2::isFinite() const {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(theta);
}

Pose2 Pose2::fromVector(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), normalizeAngle(vector.z())};
}

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  const double c = std::cos(T_a_b.theta);
  const double s = std::sin(T_a_b.theta);
  return {T_a_b.x + c * T_b_c.x - s * T_b_c.y, T_a_b.y + s * T_b_c.x + c * T_b_c.y,
          normalizeAngle(T_a_b.theta + T_b_c.theta)};
}

Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  return PointTransform(T_a_b) * p_b;
}

PointTransform::PointTransform(const Pose2& T_a_b)
    : x_(T_a_b.x), y_(T_a_b.y), cosine_(std::cos(T_a_b.theta)), sine_(std::sin(T_a_b.theta)) {}

Pose2 relativePose(const Pose2& T_c_a, const Pose2& T_c_b) { return T_c_a.inverse() * T_c_b; }

Pose2 interpolate(const Pose2& start, const Pose2& end, double share) {
  return {start.x + share * (end.x - start.x), start.y + share * (end.y - start.y),
          normalizeAngle(start.theta + share * angleDifference(end.theta, start.theta))};
}

double distance(const Pose2& a, const Pose2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace omega_slam::geometry
