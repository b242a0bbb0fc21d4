#include "omega_slam/simulation/route_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {
namespace {

constexpr double kSteeringGain = 2.5;     // [1/s] turn rate for each radian off course
constexpr double kStallDistance = 0.01;   // [m] less than this is standing still
constexpr double kStallAngle = 0.03;      // [rad]
constexpr double kBackOffPatience = 2.0;  // backing off may take so many times its ideal duration

}  // namespace

std::vector<std::string> RouteDriverConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("max_linear_speed", max_linear_speed, 0.0);
  violations.requireAbove("max_angular_speed", max_angular_speed, 0.0);
  violations.requireAbove("deceleration", deceleration, 0.0);
  violations.requireAbove("corner_speed", corner_speed, 0.0);
  violations.requireAbove("turn_in_place_angle", turn_in_place_angle, 0.0);
  violations.requireAbove("look_ahead", look_ahead, 0.0);
  violations.requireAbove("waypoint_tolerance", waypoint_tolerance, 0.0);
  violations.requireAbove("stall_time", stall_time, 0.0);
  violations.requireAbove("back_off_distance", back_off_distance, 0.0);
  violations.requireAbove("back_off_speed", back_off_speed, 0.0);
  violations.requireAtLeast("max_bumps", max_bumps, 0.0);
  return violations.sentences();
}

std::string RouteStatus::toString() const {
  switch (state) {
    case State::kDone:
      return "done";
    case State::kStuck:
      return "stuck: " + reason;
    case State::kDriving:
      break;
  }
  return fmt::format("driving {}/{}", next + 1, count);
}

RouteDriver::RouteDriver(const RouteDriverConfig& config, std::vector<Eigen::Vector2d> route)
    : config_(config), route_(std::move(route)) {
  geometry::throwIfAny(config_.validate());
  for (const Eigen::Vector2d& waypoint : route_) {
    if (!waypoint.allFinite()) {
      throw std::invalid_argument("Every waypoint of a route must be finite.");
    }
  }
}

RouteStatus RouteDriver::status() const {
  RouteStatus status;
  status.next = next_;
  status.count = route_.size();
  status.reason = stuck_reason_;
  if (!stuck_reason_.empty()) {
    status.state = RouteStatus::State::kStuck;
  } else if (next_ == route_.size()) {
    status.state = RouteStatus::State::kDone;
  }
  return status;
}

Twist2 RouteDriver::update(double now, const geometry::Pose2& T_world_base) {
  const Eigen::Vector2d position = T_world_base.translation();
  if (!started_ || now < last_update_) {
    leg_start_ = started_ ? leg_start_ : position;
    started_ = true;
    backing_off_ = false;
    last_progress_ = now;
    progress_pose_ = T_world_base;
  }
  last_update_ = now;
  passReachedWaypoints(position);
  if (status().state != RouteStatus::State::kDriving) {
    return {};
  }
  if (backing_off_ && isBackingOff(position, now)) {
    return {-config_.back_off_speed, 0.0};
  }
  if (backing_off_) {
    backing_off_ = false;
    last_progress_ = now;
  }
  watchForBumps(now, T_world_base);
  return backing_off_ || !stuck_reason_.empty() ? Twist2{} : drive(T_world_base);
}

void RouteDriver::passReachedWaypoints(const Eigen::Vector2d& position) {
  while (next_ < route_.size() && isReached(position)) {
    leg_start_ = route_[next_];
    ++next_;
    bumps_ = 0;
  }
}

bool RouteDriver::isReached(const Eigen::Vector2d& position) const {
  return (route_[next_] - position).norm() <= config_.waypoint_tolerance;
}

bool RouteDriver::isBackingOff(const Eigen::Vector2d& position, double now) const {
  return now < back_off_until_ && (position - bump_position_).norm() < config_.back_off_distance;
}

void RouteDriver::watchForBumps(double now, const geometry::Pose2& T_world_base) {
  const bool moved =
      geometry::distance(T_world_base, progress_pose_) > kStallDistance ||
      std::abs(geometry::angleDifference(T_world_base.theta, progress_pose_.theta)) > kStallAngle;
  if (moved) {
    progress_pose_ = T_world_base;
    last_progress_ = now;
  }
  if (now - last_progress_ <= config_.stall_time) {
    return;
  }
  if (++bumps_ > config_.max_bumps) {
    stuck_reason_ = fmt::format(
        "waypoint {} at ({:.2f}, {:.2f}) cannot be reached from ({:.2f}, {:.2f})", next_ + 1,
        route_[next_].x(), route_[next_].y(), T_world_base.x, T_world_base.y);
    return;
  }
  backing_off_ = true;
  bump_position_ = T_world_base.translation();
  back_off_until_ = now + kBackOffPatience * config_.back_off_distance / config_.back_off_speed;
}

Eigen::Vector2d RouteDriver::steeringPoint(const Eigen::Vector2d& position) const {
  const Eigen::Vector2d leg = route_[next_] - leg_start_;
  const double length = leg.norm();
  if (length < config_.waypoint_tolerance) {
    return route_[next_];
  }
  const double along = leg.dot(position - leg_start_) / length + config_.look_ahead;
  return leg_start_ + leg * std::clamp(along / length, 0.0, 1.0);
}

double RouteDriver::cornerSpeed() const {
  if (next_ + 1 == route_.size()) {
    return 0.0;
  }
  const Eigen::Vector2d in = route_[next_] - leg_start_;
  const Eigen::Vector2d out = route_[next_ + 1] - route_[next_];
  const double straightness = in.dot(out) / std::max(in.norm() * out.norm(), 1e-9);
  return std::max(config_.corner_speed, config_.max_linear_speed * straightness * straightness *
                                            (straightness > 0.0 ? 1.0 : 0.0));
}

Twist2 RouteDriver::drive(const geometry::Pose2& T_world_base) const {
  const Eigen::Vector2d position = T_world_base.translation();
  const Eigen::Vector2d ahead = steeringPoint(position) - position;
  const double off_course =
      geometry::angleDifference(std::atan2(ahead.y(), ahead.x()), T_world_base.theta);
  Twist2 twist;
  twist.angular =
      std::clamp(kSteeringGain * off_course, -config_.max_angular_speed, config_.max_angular_speed);
  if (std::abs(off_course) > config_.turn_in_place_angle) {
    return twist;
  }
  const double distance =
      std::max(0.0, (route_[next_] - position).norm() - config_.waypoint_tolerance);
  const double corner = cornerSpeed();
  const double braking = std::sqrt(corner * corner + 2.0 * config_.deceleration * distance);
  const double on_course = 1.0 - std::abs(off_course) / config_.turn_in_place_angle;
  // Never quite zero, or it would stop just short of the last waypoint.
  twist.linear = std::clamp(on_course * std::min(braking, config_.max_linear_speed),
                            0.1 * config_.corner_speed, config_.max_linear_speed);
  return twist;
}

}  // namespace omega_slam::simulation
