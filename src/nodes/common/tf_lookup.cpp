#include "nodes/common/tf_lookup.h"

#include <fmt/format.h>
#include <tf2/exceptions.h>

#include <Eigen/Geometry>
#include <cmath>

#include "nodes/common/conversions.h"

namespace omega_slam {
namespace {

// A mount is upright or upside down up to this tilt [rad]; beyond, beams leave the plane by more
// than a grid cell within a metre.
constexpr double kMaxTilt = 0.05;

// tf2 calls a time of zero "the newest there is".
const ros::Time kNewest(0);

std::string missing(const std::string& target, const std::string& source, const std::string& stamp,
                    const std::string& cause) {
  return fmt::format("There is no transform from frame '{}' to frame '{}' at {}: {}", source,
                     target, stamp, cause);
}

std::string timeName(const ros::Time& stamp) {
  return stamp.isZero() ? "any time" : fmt::format("time {:.6f}", stamp.toSec());
}

}  // namespace

std::string frameName(const std::string& frame) {
  const auto first = frame.find_first_not_of('/');
  return first == std::string::npos ? std::string() : frame.substr(first);
}

TfAnswer<sensing::LaserMount> laserMountFrom(const geometry_msgs::TransformStamped& transform) {
  const auto& q = transform.transform.rotation;
  const auto& t = transform.transform.translation;
  const Eigen::Quaterniond quaternion(q.w, q.x, q.y, q.z);
  const std::string frames =
      fmt::format("The transform from frame '{}' to frame '{}' at {}", transform.child_frame_id,
                  transform.header.frame_id, timeName(transform.header.stamp));
  if (!isRotation(q) || !std::isfinite(t.x) || !std::isfinite(t.y)) {
    return {std::nullopt, frames + " is not a rigid motion of finite numbers."};
  }
  const Eigen::Matrix3d R_base_laser = quaternion.normalized().toRotationMatrix();
  const double upright = R_base_laser(2, 2);  // cosine of the angle between the two z axes
  if (std::abs(upright) < std::cos(kMaxTilt)) {
    return {std::nullopt,
            fmt::format("{} tilts the laser by {:.3f} rad; a plane needs one that is level, either "
                        "upright or upside down.",
                        frames, std::acos(std::abs(upright)))};
  }
  sensing::LaserMount mount;
  mount.T_base_laser = {t.x, t.y, std::atan2(R_base_laser(1, 0), R_base_laser(0, 0))};
  mount.upside_down = upright < 0.0;
  return {mount, {}};
}

TfAnswer<sensing::LaserMount> lookupLaserMount(const tf2::BufferCore& buffer,
                                               const std::string& base_frame,
                                               const std::string& laser_frame,
                                               const ros::Time& stamp) {
  const std::string target = frameName(base_frame);
  const std::string source = frameName(laser_frame);
  try {
    const bool reaches = buffer.canTransform(target, source, stamp);
    return laserMountFrom(buffer.lookupTransform(target, source, reaches ? stamp : kNewest));
  } catch (const tf2::TransformException& error) {
    return {std::nullopt, missing(target, source, timeName(stamp), error.what())};
  }
}

TfAnswer<geometry::StampedPose2> lookupPose(const tf2::BufferCore& buffer,
                                            const std::string& frame_a, const std::string& frame_b,
                                            const ros::Time& stamp) {
  const std::string target = frameName(frame_a);
  const std::string source = frameName(frame_b);
  try {
    const auto transform = buffer.lookupTransform(target, source, stamp);
    const auto pose = poseFromRos(transform.transform);
    if (!pose) {
      return {std::nullopt,
              fmt::format("The transform from frame '{}' to frame '{}' at {} is not a rigid motion "
                          "of finite numbers.",
                          source, target, timeName(transform.header.stamp))};
    }
    return {geometry::StampedPose2{transform.header.stamp.toSec(), *pose}, {}};
  } catch (const tf2::TransformException& error) {
    return {std::nullopt, missing(target, source, timeName(stamp), error.what())};
  }
}

TfAnswer<geometry::StampedPose2> lookupOdometry(const tf2::BufferCore& buffer,
                                                const std::string& odom_frame,
                                                const std::string& base_frame) {
  return lookupPose(buffer, odom_frame, base_frame, kNewest);
}

}  // namespace omega_slam
