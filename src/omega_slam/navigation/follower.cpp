#include "omega_slam/navigation/follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"
#include "omega_slam/motion/arc.h"

namespace omega_slam::navigation {
namespace {

constexpr double kArc = 0.6;             // [m] that motions are looked at ahead,
constexpr double kShortestArc = 0.12;    // [m] but at the end of a path only so far,
constexpr double kArcStep = 0.05;        // [m] in such steps
constexpr double kSearchAhead = 1.5;     // [m] of the path in which progress is looked for
constexpr double kTurnEnough = 0.25;     // [rad] off course, from which a turn on the spot is over
constexpr double kStandingSpeed = 0.03;  // [m/s] and [rad/s], slower counts as standing
constexpr double kLeastSpeed = 0.01;     // [m/s] of a drive
constexpr double kTightSpeed = 0.12;     // [m/s] however tight it is
constexpr double kStraightEnough = 0.1;  // [rad] off course, from which turning does not help
constexpr double kContactSlack = 0.005;  // [m] it may come nearer to what it touches
constexpr double kCrawl = 0.06;          // [m/s] never slower than this towards the end
constexpr double kOffPathWeight = 1.5;   // of a metre beside the path, in metres of progress
constexpr double kCourseWeight = 0.35;   // [m/rad]
constexpr double kRoomWeight = 1.0;      // of a metre of room that lacks to be comfortable
constexpr double kComfort = 0.15;        // [m] beyond the footprint

double approach(double value, double target, double max_change) {
  return value + std::clamp(target - value, -max_change, max_change);
}

bool isLess(const Costmap::Room& room, const Costmap::Room& least) {
  return room.solid < least.solid || room.seen < least.seen;
}

/// The sample of that number, evenly from `first` to `last`.
double at(double first, double last, int number, int count) {
  return first + (last - first) * number / (count - 1);
}

}  // namespace

std::vector<std::string> FollowerConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("max_linear_speed", max_linear_speed, 0.0);
  violations.requireAbove("max_angular_speed", max_angular_speed, 0.0);
  violations.requireAbove("max_linear_acceleration", max_linear_acceleration, 0.0);
  violations.requireAbove("max_angular_acceleration", max_angular_acceleration, 0.0);
  violations.requireWithin("horizon", horizon, 0.2, 10.0);
  violations.requireAbove("look_ahead", look_ahead, 0.0);
  violations.requireWithin("turn_in_place_angle", turn_in_place_angle, 0.3, geometry::kPi);
  violations.requireAtLeast("clearance_time", clearance_time, 0.0);
  violations.requireAbove("position_tolerance", position_tolerance, 0.0);
  violations.requireAbove("heading_tolerance", heading_tolerance, 0.0);
  violations.requireWithin("linear_samples", linear_samples, 2.0, 100.0);
  violations.requireWithin("angular_samples", angular_samples, 3.0, 100.0);
  return violations.sentences();
}

Follower::Follower(const FollowerConfig& config, const Footprint& footprint)
    : config_(config),
      radius_(footprint.circumscribed_radius),
      base_radius_(footprint.inscribed_radius) {
  geometry::throwIfAny(config_.validate());
}

void Follower::follow(const Path& path, std::optional<double> heading) {
  path_ = PathMeasure(path);
  heading_ = heading;
  along_ = off_path_ = 0.0;
  at_end_ = false;
}

FollowerStep Follower::step(const Costmap& costmap, const geometry::Pose2& T_map_base,
                            const motion::Twist2& velocity, double dt) {
  if (path_.empty()) {
    return {FollowState::kArrived, brake(velocity, dt), {}, 0.0};
  }
  const Eigen::Vector2d position = T_map_base.translation();
  const auto projection = path_.project(position, along_, along_ + kSearchAhead);
  along_ = projection.along;
  off_path_ = projection.distance;
  const double to_end = (path_.path().back() - position).norm();
  // Once there, it turns to its heading, even if that carries it off a little.
  at_end_ = to_end <= config_.position_tolerance * (at_end_ ? 2.0 : 1.0) &&
            path_.length() - along_ <= 2.0 * config_.position_tolerance;
  FollowerStep result;
  if (at_end_) {
    result = arrive(T_map_base, velocity, dt);
  } else {
    const double off_course = courseError(T_map_base, along_);
    turning_ = std::abs(off_course) > (turning_ ? kTurnEnough : config_.turn_in_place_angle);
    if (turning_) {
      result.state = FollowState::kTurning;
      result.velocity = turn(off_course, velocity, dt);
    } else {
      result = choose(costmap, T_map_base, velocity, dt);
    }
  }
  result.left = path_.length() - along_;
  return result;
}

FollowerStep Follower::arrive(const geometry::Pose2& T_map_base, const motion::Twist2& velocity,
                              double dt) {
  const double error = heading_ ? geometry::angleDifference(*heading_, T_map_base.theta) : 0.0;
  FollowerStep result;
  if (std::abs(error) > config_.heading_tolerance) {
    result.state = FollowState::kTurning;
    result.velocity = turn(error, velocity, dt);
    return result;
  }
  result.velocity = brake(velocity, dt);
  const bool stands =
      std::abs(velocity.linear) < kStandingSpeed && std::abs(velocity.angular) < kStandingSpeed;
  result.state = stands ? FollowState::kArrived : FollowState::kTurning;
  return result;
}

double Follower::courseError(const geometry::Pose2& pose, double along) const {
  const Eigen::Vector2d ahead = path_.at(along + config_.look_ahead) - pose.translation();
  return ahead.norm() < 1e-6
             ? 0.0
             : geometry::angleDifference(std::atan2(ahead.y(), ahead.x()), pose.theta);
}

motion::Twist2 Follower::turn(double angle, const motion::Twist2& velocity, double dt) const {
  const double stoppable = std::sqrt(2.0 * config_.max_angular_acceleration * std::abs(angle));
  // It is only seen again after dt: half the speed that could still be stopped leaves room for it.
  const double speed = std::min(config_.max_angular_speed, 0.7 * stoppable);
  return {approach(velocity.linear, 0.0, config_.max_linear_acceleration * dt),
          approach(velocity.angular, std::copysign(speed, angle),
                   config_.max_angular_acceleration * dt)};
}

motion::Twist2 Follower::brake(const motion::Twist2& velocity, double dt) const {
  return {approach(velocity.linear, 0.0, config_.max_linear_acceleration * dt),
          approach(velocity.angular, 0.0, config_.max_angular_acceleration * dt)};
}

Costmap::Room Follower::leastRoom(const Costmap::Room& here) const {
  return {std::min(radius_, here.solid - kContactSlack), std::min(base_radius_, here.seen)};
}

Follower::Outlook Follower::lookAlong(const Costmap& costmap, const geometry::Pose2& T_map_base,
                                      const motion::Twist2& velocity) const {
  const Costmap::Room here = costmap.roomAt(T_map_base.translation());
  const Costmap::Room least = leastRoom(here);
  const double left = (path_.path().back() - T_map_base.translation()).norm();
  const double reach = std::clamp(left, kShortestArc, kArc);
  const int steps = static_cast<int>(std::ceil(reach / kArcStep));
  Outlook outlook;
  outlook.reach = reach;
  outlook.room = here.solid;
  for (int i = 1; i <= steps; ++i) {
    const double length = reach * i / steps;
    const double bent = std::min(length, config_.horizon * velocity.linear);
    const geometry::Pose2 pose =
        T_map_base * motion::Arc{bent, bent * velocity.angular / velocity.linear}.toMotion() *
        geometry::Pose2{length - bent, 0.0, 0.0};
    const Costmap::Room room = costmap.roomAt(pose.translation());
    if (isLess(room, least)) {
      break;
    }
    outlook.room = std::min(outlook.room, room.solid);
    outlook.clear = length;
    outlook.arc.push_back(pose);
  }
  return outlook;
}

double Follower::speedWithin(double room) const {
  const double spare = std::max(0.0, room - radius_);
  return config_.clearance_time > 0.0 ? std::max(kTightSpeed, spare / config_.clearance_time)
                                      : config_.max_linear_speed;
}

double Follower::score(const Outlook& outlook, double speed) const {
  const geometry::Pose2& end = outlook.arc.back();
  const auto projection =
      path_.project(end.translation(), along_, along_ + kSearchAhead + config_.look_ahead);
  const double lack = std::max(0.0, radius_ + kComfort - outlook.room);
  return projection.along - outlook.reach + config_.horizon * speed -
         kOffPathWeight * projection.distance - kRoomWeight * lack -
         kCourseWeight * std::abs(courseError(end, projection.along));
}

FollowerStep Follower::choose(const Costmap& costmap, const geometry::Pose2& T_map_base,
                              const motion::Twist2& velocity, double dt) const {
  const Window window = windowAbout(T_map_base, velocity, dt);
  FollowerStep best;
  best.state = FollowState::kBlocked;
  double best_score = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < config_.linear_samples; ++i) {
    const double linear = at(window.slowest, window.fastest, i, config_.linear_samples);
    if (linear < kLeastSpeed) {
      continue;
    }
    for (int j = 0; j < config_.angular_samples; ++j) {
      const double angular = at(window.right, window.left, j, config_.angular_samples);
      Outlook outlook = lookAlong(costmap, T_map_base, {linear, angular});
      if (!isAdmissible(outlook, linear, velocity.linear, dt)) {
        continue;
      }
      if (const double value = score(outlook, linear); value > best_score) {
        best_score = value;
        best = {FollowState::kDriving, {linear, angular}, std::move(outlook.arc), 0.0};
      }
    }
  }
  if (best.state == FollowState::kBlocked) {
    // Its own disc it may always turn in, and from another course there may be a way.
    const double off_course = courseError(T_map_base, along_);
    const bool turns = std::abs(off_course) > kStraightEnough;
    best.state = turns ? FollowState::kTurning : FollowState::kBlocked;
    best.velocity = turns ? turn(off_course, velocity, dt) : brake(velocity, dt);
  }
  return best;
}

bool Follower::isAdmissible(const Outlook& outlook, double speed, double present, double dt) const {
  // Braking is always allowed where there is less room than the speed asks for.
  const double slower = present - 0.5 * config_.max_linear_acceleration * dt;
  if (speed > std::max(speedWithin(outlook.room), slower)) {
    return false;
  }
  const double to_stop = speed * (dt + 0.5 * speed / config_.max_linear_acceleration);
  return !outlook.arc.empty() && outlook.clear >= std::min(to_stop, outlook.reach);
}

Follower::Window Follower::windowAbout(const geometry::Pose2& T_map_base,
                                       const motion::Twist2& velocity, double dt) const {
  const double left = (path_.path().back() - T_map_base.translation()).norm();
  const double stoppable = std::max(kCrawl, std::sqrt(config_.max_linear_acceleration * left));
  const double linear_change = config_.max_linear_acceleration * dt;
  const double angular_change = config_.max_angular_acceleration * dt;
  Window window;
  window.slowest = std::max(0.0, velocity.linear - linear_change);
  window.fastest =
      std::max(window.slowest,
               std::min({config_.max_linear_speed, stoppable, velocity.linear + linear_change}));
  window.right = std::max(-config_.max_angular_speed, velocity.angular - angular_change);
  window.left = std::min(config_.max_angular_speed, velocity.angular + angular_change);
  return window;
}

bool Follower::isClearStraight(const Costmap& costmap, const geometry::Pose2& T_map_base,
                               double distance) const {
  const Costmap::Room least = leastRoom(costmap.roomAt(T_map_base.translation()));
  const int steps = static_cast<int>(std::ceil(std::abs(distance) / kStandingSpeed));
  for (int i = 1; i <= steps; ++i) {
    const double done = distance * i / steps;
    const Eigen::Vector2d point =
        T_map_base.translation() + T_map_base.rotation() * Eigen::Vector2d(done, 0.0);
    if (isLess(costmap.roomAt(point), least)) {
      return false;
    }
  }
  return true;
}

}  // namespace omega_slam::navigation
