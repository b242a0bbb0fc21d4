#include "omega_slam/slam/belief.h"

#include <Eigen/Cholesky>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::slam {

Eigen::Vector3d differenceOf(const geometry::Pose2& a, const geometry::Pose2& b) {
  return {a.x - b.x, a.y - b.y, geometry::angleDifference(a.theta, b.theta)};
}

double squaredDistance(const Belief& a, const Belief& b) {
  const Eigen::Vector3d difference = differenceOf(a.pose, b.pose);
  const Eigen::Matrix3d spread = a.covariance + b.covariance;
  return difference.dot(spread.ldlt().solve(difference));
}

}  // namespace omega_slam::slam
