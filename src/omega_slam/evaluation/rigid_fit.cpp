#include "omega_slam/evaluation/rigid_fit.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::evaluation {

geometry::Pose2 fitRigidMotion(const std::vector<PointPair>& pairs, double otherwise) {
  const auto count = static_cast<double>(pairs.size());
  Eigen::Vector2d mean_a = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_b = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) {
    mean_a += pair.p_a / count;
    mean_b += pair.p_b / count;
  }
  double cosine = 0.0;
  double sine = 0.0;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector2d a = pair.p_a - mean_a;
    const Eigen::Vector2d b = pair.p_b - mean_b;
    cosine += a.dot(b);
    sine += a.x() * b.y() - a.y() * b.x();
  }
  constexpr double kStandingStill = 1e-6;  // [m^2]
  const bool moved = std::hypot(cosine, sine) > kStandingStill * count;
  const double theta = moved ? std::atan2(sine, cosine) : otherwise;
  const Eigen::Vector2d turned = geometry::Pose2{0.0, 0.0, theta} * mean_a;
  return {mean_b.x() - turned.x(), mean_b.y() - turned.y(), geometry::normalizeAngle(theta)};
}

}  // namespace omega_slam::evaluation
