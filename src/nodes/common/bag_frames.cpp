#include "nodes/common/bag_frames.h"

#include <fmt/format.h>
#include <rosbag/query.h>
#include <rosbag/view.h>

#include <algorithm>

#include "nodes/common/tf_lookup.h"

namespace omega_slam {
namespace {

// tf2 calls a time of zero "the newest there is".
const ros::Time kNewest(0);

// Stamps of one frame that fall back by more than this [s] are a clock that was set back.
constexpr double kJump = 1.0;

constexpr char kAuthority[] = "bag";
constexpr std::size_t kMostLinks = 12;  // that a message lists

bool isLinkedToOdometry(const BagFrames& frames, const std::string& base,
                        const BagRoleRequest& request) {
  return request.odom_frame.empty() || frames.connects(request.odom_frame, base);
}

/// The roles with this base, if what has been read so far tells them.
std::optional<BagRoles> rolesWith(const BagFrames& frames, const std::string& base,
                                  const std::string& path, const BagRoleRequest& request) {
  if (!isLinkedToOdometry(frames, base, request)) {
    return std::nullopt;
  }
  if (request.laser_pose) {
    return BagRoles{base, {*request.laser_pose, false}};
  }
  if (!frames.connects(base, request.laser_frame)) {
    return std::nullopt;
  }
  const auto mount = lookupLaserMount(frames.buffer(), base, request.laser_frame, kNewest);
  if (!mount.value) {
    throw BagError(path + ": " + mount.problem);
  }
  return BagRoles{base, *mount.value};
}

[[noreturn]] void refuse(const BagFrames& frames, const std::string& path,
                         const BagRoleRequest& request) {
  const std::string bases = fmt::format("{}", fmt::join(request.base_frames, "' or '"));
  for (const std::string& base : request.base_frames) {
    if (isLinkedToOdometry(frames, base, request)) {
      throw BagError(fmt::format(
          "{}: there is no transform from the laser's frame '{}' to the robot's base '{}'; say "
          "where "
          "the laser sits with --laser-pose X Y YAW. {}",
          path, request.laser_frame, request.odom_frame.empty() ? bases : base, frames.links()));
    }
  }
  throw BagError(
      fmt::format("{}: there is no odometry: no topic of nav_msgs/Odometry, and no transform from "
                  "'{}' to '{}'. {}",
                  path, bases, request.odom_frame, frames.links()));
}

}  // namespace

void BagFrames::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (geometry_msgs::TransformStamped transform : message.transforms) {
    transform.header.frame_id = frameName(transform.header.frame_id);
    transform.child_frame_id = frameName(transform.child_frame_id);
    if (!is_static) {
      forgetIfClockJumpedBack(transform);
    }
    if (buffer_.setTransform(transform, kAuthority, is_static)) {
      parents_[transform.child_frame_id] = transform.header.frame_id;
    }
  }
}

void BagFrames::forgetIfClockJumpedBack(const geometry_msgs::TransformStamped& transform) {
  const double stamp = transform.header.stamp.toSec();
  const auto newest = newest_.insert({transform.child_frame_id, stamp}).first;
  if (stamp < newest->second - kJump) {
    buffer_.clear();
    newest_ = {{transform.child_frame_id, stamp}};
  } else {
    newest->second = std::max(newest->second, stamp);
  }
}

bool BagFrames::connects(const std::string& a, const std::string& b) const {
  return buffer_.canTransform(a, b, kNewest);
}

std::string BagFrames::links() const {
  std::vector<std::string> links;
  for (const auto& [child, parent] : parents_) {
    links.push_back(fmt::format("{} -> {}", parent, child));
  }
  if (links.empty()) {
    return "There is no tf in it.";
  }
  const std::size_t all = links.size();
  links.resize(std::min(all, kMostLinks));
  return fmt::format("Its tf links {}{}.", fmt::join(links, ", "),
                     all > kMostLinks ? fmt::format(" and {} more", all - kMostLinks) : "");
}

BagRoles findRoles(const rosbag::Bag& bag, const std::string& path, const BagTopics& topics,
                   const BagRoleRequest& request) {
  BagFrames frames;
  if (auto roles = rolesWith(frames, request.base_frames.front(), path, request)) {
    return *roles;
  }
  rosbag::View view(bag, rosbag::TopicQuery(topics.tf));
  for (const rosbag::MessageInstance& instance : view) {
    requireSaneSize(instance, bag, path);
    if (const auto message = instance.instantiate<tf2_msgs::TFMessage>()) {
      frames.add(*message, isStaticTf(instance.getTopic()));
    }
    if (auto roles = rolesWith(frames, request.base_frames.front(), path, request)) {
      return *roles;
    }
  }
  // The better names may have come at the end only, so the others were not tried before.
  for (const std::string& base : request.base_frames) {
    if (auto roles = rolesWith(frames, base, path, request)) {
      return *roles;
    }
  }
  refuse(frames, path, request);
}

}  // namespace omega_slam
