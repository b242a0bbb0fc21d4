#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Points and poses of the plane as PCL has them, in space and single precision.
[[nodiscard]] pcl::PointCloud<pcl::PointXYZ>::Ptr toCloud(const Points& points);
[[nodiscard]] Eigen::Matrix4f toMatrix(const geometry::Pose2& pose);
[[nodiscard]] geometry::Pose2 toPose(const Eigen::Matrix4f& matrix);

}  // namespace omega_slam::matching
