#include "nodes/common/conversions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam {
namespace {

// Drivers round to a few digits; a quaternion farther from unit length than this is not one.
constexpr double kQuaternionTolerance = 0.01;

// Headings are read to the nearest of these [rad], 2^-40, about 1e-12. What sine, cosine and arc
// tangent have lost is so given back: a pose comes out of any number of messages as it went into
// the first.
constexpr double kHeadingStep = 1.0 / (std::uint64_t{1} << 40U);

// x, y and yaw among x, y, z, rotX, rotY, rotZ.
constexpr std::array<int, 3> kPlanarAxes{0, 1, 5};

std::size_t covarianceIndex(int row, int col) {
  return static_cast<std::size_t>(6 * kPlanarAxes[static_cast<std::size_t>(row)] +
                                  kPlanarAxes[static_cast<std::size_t>(col)]);
}

double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

geometry_msgs::Quaternion quaternionFromYaw(double yaw) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(0.5 * yaw);
  q.w = std::cos(0.5 * yaw);
  return q;
}

std::optional<geometry::Pose2> planarPose(double x, double y, const geometry_msgs::Quaternion& q) {
  if (!isRotation(q)) {
    return std::nullopt;
  }
  const double yaw = kHeadingStep * std::nearbyint(yawOf(q) / kHeadingStep);
  const geometry::Pose2 pose{x, y, geometry::normalizeAngle(yaw)};
  return pose.isFinite() ? std::optional(pose) : std::nullopt;
}

}  // namespace

ros::Time timeToRos(double seconds) {
  constexpr double kLatest = std::numeric_limits<std::uint32_t>::max();
  if (!(seconds > 0.0)) {
    return ros::Time(0);
  }
  // Split by hand: ros::Time(double) throws where the seconds do not fit.
  const double clamped = std::min(seconds, kLatest);
  const double whole = std::floor(clamped);
  const double nanoseconds = std::floor((clamped - whole) * 1e9 + 0.5);
  if (nanoseconds >= 1e9) {
    return ros::Time(static_cast<std::uint32_t>(std::min(whole + 1.0, kLatest)), 0);
  }
  return ros::Time(static_cast<std::uint32_t>(whole), static_cast<std::uint32_t>(nanoseconds));
}

bool isRotation(const geometry_msgs::Quaternion& q) {
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return std::abs(norm - 1.0) <= kQuaternionTolerance;  // false for NaN, too
}

std::optional<geometry::Pose2> poseFromRos(const geometry_msgs::Pose& pose) {
  return planarPose(pose.position.x, pose.position.y, pose.orientation);
}

std::optional<geometry::Pose2> poseFromRos(const geometry_msgs::Transform& transform) {
  return planarPose(transform.translation.x, transform.translation.y, transform.rotation);
}

std::optional<geometry::Pose2> poseFromRos(const omega_slam::Pose2& pose) {
  const geometry::Pose2 read{pose.x, pose.y, pose.theta};
  if (!read.isFinite()) {
    return std::nullopt;
  }
  return geometry::Pose2{read.x, read.y, geometry::normalizeAngle(read.theta)};
}

geometry_msgs::Pose poseToRos(const geometry::Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = quaternionFromYaw(pose.theta);
  return message;
}

geometry_msgs::Transform transformToRos(const geometry::Pose2& pose) {
  geometry_msgs::Transform message;
  message.translation.x = pose.x;
  message.translation.y = pose.y;
  message.rotation = quaternionFromYaw(pose.theta);
  return message;
}

omega_slam::Pose2 pose2ToRos(const geometry::Pose2& pose) {
  omega_slam::Pose2 message;
  message.x = pose.x;
  message.y = pose.y;
  message.theta = pose.theta;
  return message;
}

std::optional<Eigen::Matrix3d> covarianceFromRos(
    const geometry_msgs::PoseWithCovariance::_covariance_type& covariance) {
  Eigen::Matrix3d planar;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) {
      planar(row, col) = covariance[covarianceIndex(row, col)];
    }
  }
  const bool is_valid = planar.allFinite() && (planar.diagonal().array() >= 0.0).all();
  return is_valid ? std::optional(planar) : std::nullopt;
}

geometry_msgs::PoseWithCovariance::_covariance_type covarianceToRos(
    const Eigen::Matrix3d& covariance) {
  geometry_msgs::PoseWithCovariance::_covariance_type message;
  message.fill(0.0);
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) {
      message[covarianceIndex(row, col)] = covariance(row, col);
    }
  }
  return message;
}

sensing::LaserScan scanFromRos(const sensor_msgs::LaserScan& scan) {
  sensing::LaserScan read;
  read.stamp = scan.header.stamp.toSec();
  read.angle_min = static_cast<double>(scan.angle_min);
  read.angle_increment = static_cast<double>(scan.angle_increment);
  read.time_increment = static_cast<double>(scan.time_increment);
  read.range_min = static_cast<double>(scan.range_min);
  read.range_max = static_cast<double>(scan.range_max);
  read.ranges = scan.ranges;
  return read;
}

nav_msgs::OccupancyGrid gridToRos(const grid::OccupancyGrid& grid, const std::string& frame,
                                  const ros::Time& stamp) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  message.info.map_load_time = stamp;
  message.info.resolution = static_cast<float>(grid.geometry.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.geometry.width);
  message.info.height = static_cast<std::uint32_t>(grid.geometry.height);
  message.info.origin = poseToRos({grid.geometry.origin.x(), grid.geometry.origin.y(), 0.0});
  message.data.assign(grid.cells.begin(), grid.cells.end());
  return message;
}

map_msgs::OccupancyGridUpdate gridUpdateToRos(const grid::OccupancyGrid& grid,
                                              const Eigen::AlignedBox<int, 2>& cells,
                                              const std::string& frame, const ros::Time& stamp) {
  map_msgs::OccupancyGridUpdate message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  message.x = cells.min().x();
  message.y = cells.min().y();
  message.width = static_cast<std::uint32_t>(cells.sizes().x() + 1);
  message.height = static_cast<std::uint32_t>(cells.sizes().y() + 1);
  message.data.reserve(std::size_t{message.width} * message.height);
  for (int y = cells.min().y(); y <= cells.max().y(); ++y) {
    const auto row =
        grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.geometry.index({cells.min().x(), y}));
    message.data.insert(message.data.end(), row, row + message.width);
  }
  return message;
}

std::optional<grid::OccupancyGrid> gridFromRos(const nav_msgs::OccupancyGrid& grid) {
  constexpr std::uint32_t kMaxSide = std::numeric_limits<std::int32_t>::max();
  const auto origin = poseFromRos(grid.info.origin);
  const auto cells = static_cast<std::uint64_t>(grid.info.width) * grid.info.height;
  const bool is_placed = origin && origin->theta == 0.0 && std::isfinite(grid.info.resolution) &&
                         grid.info.resolution > 0.0F;
  const bool is_filled = grid.info.width <= kMaxSide && grid.info.height <= kMaxSide &&
                         cells == grid.data.size() &&
                         std::all_of(grid.data.begin(), grid.data.end(),
                                     [](std::int8_t cell) { return cell >= -1 && cell <= 100; });
  if (!is_placed || !is_filled) {
    return std::nullopt;
  }
  grid::OccupancyGrid read;
  read.geometry.resolution = static_cast<double>(grid.info.resolution);
  read.geometry.origin = origin->translation();
  read.geometry.width = static_cast<int>(grid.info.width);
  read.geometry.height = static_cast<int>(grid.info.height);
  read.cells.assign(grid.data.begin(), grid.data.end());
  return read;
}

}  // namespace omega_slam
