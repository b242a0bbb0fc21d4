#include "nodes/common/navigation_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "nodes/common/conversions.h"

namespace omega_slam {
namespace {

constexpr double kBumperReach = 2.0;  // radii of the robot within which pressed bumpers lie
constexpr double kTouched = 99.0;     // value of a place where the robot would touch something

/// Whether an iterator over this field stays within the cloud's data.
bool hasFloats(const sensor_msgs::PointCloud2& cloud, const std::string& name) {
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&](const auto& one) { return one.name == name; });
  return field != cloud.fields.end() && field->datatype == sensor_msgs::PointField::FLOAT32 &&
         !cloud.is_bigendian && field->offset + sizeof(float) <= cloud.point_step &&
         cloud.data.size() ==
             static_cast<std::size_t>(cloud.point_step) * cloud.width * cloud.height;
}

std::vector<Eigen::Vector2d> pointsWithin(const sensor_msgs::PointCloud2& cloud, double reach) {
  std::vector<Eigen::Vector2d> points;
  if (!hasFloats(cloud, "x") || !hasFloats(cloud, "y")) {
    return points;
  }
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(cloud, "y");
  for (; x != x.end(); ++x, ++y) {
    const Eigen::Vector2d point(static_cast<double>(*x), static_cast<double>(*y));
    if (point.norm() < reach) {  // and not NaN
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace

nav_msgs::Path posesToRos(const std::vector<geometry::Pose2>& poses, const std::string& frame,
                          const ros::Time& stamp) {
  nav_msgs::Path message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  for (const geometry::Pose2& pose : poses) {
    geometry_msgs::PoseStamped stamped;
    stamped.header = message.header;
    stamped.pose = poseToRos(pose);
    message.poses.push_back(stamped);
  }
  return message;
}

nav_msgs::Path pathToRos(const navigation::Path& path, double heading, const std::string& frame,
                         const ros::Time& stamp) {
  std::vector<geometry::Pose2> poses;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool last = i + 1 == path.size();
    const Eigen::Vector2d ahead = last ? Eigen::Vector2d(1.0, 0.0) : path[i + 1] - path[i];
    poses.push_back({path[i].x(), path[i].y(), last ? heading : std::atan2(ahead.y(), ahead.x())});
  }
  return posesToRos(poses, frame, stamp);
}

nav_msgs::OccupancyGrid costmapToRos(const navigation::Costmap& costmap,
                                     const navigation::ClearanceCost& cost,
                                     const std::string& frame, const ros::Time& stamp) {
  grid::OccupancyGrid result = grid::makeGrid(costmap.geometry(), grid::kUnknown);
  for (int row = 0; row < result.geometry.height; ++row) {
    for (int column = 0; column < result.geometry.width; ++column) {
      const grid::Cell cell(column, row);
      if (costmap.isUnknown(cell)) {
        continue;
      }
      const double clearance = costmap.clearance(result.geometry.center(cell));
      const double lack = (cost.perMetre(clearance) - 1.0) / std::max(cost.weight, 1e-9);
      const double value = clearance <= 0.0          ? grid::kOccupied
                           : clearance < cost.radius ? kTouched
                                                     : (kTouched - 1.0) * lack;
      result.at(cell) = static_cast<std::int8_t>(std::lround(value));
    }
  }
  return gridToRos(result, frame, stamp);
}

TfAnswer<std::vector<Eigen::Vector2d>> contactsOf(const sensor_msgs::PointCloud2& bumper,
                                                  double robot_radius,
                                                  const std::string& base_frame,
                                                  const tf2::BufferCore& buffer) {
  std::vector<Eigen::Vector2d> contacts = pointsWithin(bumper, kBumperReach * robot_radius);
  if (contacts.empty()) {
    return {std::move(contacts), {}};
  }
  const auto T_base_bumper = lookupPose(buffer, base_frame, bumper.header.frame_id, ros::Time(0));
  if (!T_base_bumper.value) {
    return {std::nullopt, T_base_bumper.problem};
  }
  for (Eigen::Vector2d& contact : contacts) {
    contact = T_base_bumper.value->pose * contact;
  }
  return {std::move(contacts), {}};
}

}  // namespace omega_slam
