#include "omega_slam/matching/pcl_conversions.h"

#include <cmath>

namespace omega_slam::matching {

using geometry::Pose2;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr toCloud(const Points& points) {
  auto cloud = Cloud::Ptr(new Cloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    cloud->push_back(
        pcl::PointXYZ(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F));
  }
  return cloud;
}

Eigen::Matrix4f toMatrix(const Pose2& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<2, 2>() = pose.rotation();
  matrix.topRightCorner<2, 1>() = pose.translation();
  return matrix.cast<float>();
}

Pose2 toPose(const Eigen::Matrix4f& matrix) {
  const Eigen::Matrix4d m = matrix.cast<double>();
  return {m(0, 3), m(1, 3), std::atan2(m(1, 0), m(0, 0))};
}

}  // namespace omega_slam::matching
