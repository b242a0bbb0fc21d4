#include "omega_slam/navigation/navigator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::navigation {
namespace {

constexpr double kLeastStep = 0.02;    // [s] shorter and longer steps are taken as this long
constexpr double kLongestStep = 0.25;  // [s]
constexpr double kMotion = 0.05;       // [m] and [rad/4], from which the robot has moved
constexpr double kNearer = 0.3;        // [m] from which it has come nearer to the goal
constexpr double kOffPath = 0.35;      // [m] beside its path it needs a new one
constexpr double kBetter = 0.9;        // share of the old way's cost that a new one must stay below
constexpr double kDetour = 1.0;        // [m] that a way around something is longer at least
constexpr int kMostDetours = 5;        // after which detours don't count as coming nearer
constexpr double kJump = 0.15;         // [m] that a pose leaps when the map is corrected
constexpr double kSelf = 0.9;  // share of the inscribed radius: what is seen in there is the robot

Sighting inMap(const Sighting& sighting, const geometry::Pose2& T_map_base, double self) {
  Sighting result;
  result.stamp = sighting.stamp;
  result.origin = T_map_base * sighting.origin;
  for (const Eigen::Vector2d& p_base : sighting.returns) {
    if (p_base.norm() >= self) {
      result.returns.push_back(T_map_base * p_base);
    }
  }
  for (const Eigen::Vector2d& p_base : sighting.clear) {
    result.clear.push_back(T_map_base * p_base);
  }
  return result;
}

}  // namespace

std::vector<std::string> NavigatorConfig::validate() const {
  geometry::Violations violations;
  violations.include("costmap", costmap.validate());
  violations.include("planner", planner.validate());
  violations.include("follower", follower.validate());
  violations.include("recovery", recovery.validate());
  violations.requireWithin("margin", margin, 0.0, 1.0);
  violations.requireAtLeast("replan_interval", replan_interval, 0.0);
  violations.requireAbove("max_input_age", max_input_age, 0.0);
  violations.requireAtLeast("input_patience", input_patience, 0.0);
  violations.requireAbove("stall_time", stall_time, 0.0);
  violations.requireAbove("progress_time", progress_time, 0.0);
  violations.requireAtLeast("blocked_time", blocked_time, 0.0);
  return violations.sentences();
}

Navigator::Navigator(const NavigatorConfig& config, const Footprint& footprint)
    : config_(config),
      radius_(footprint.circumscribed_radius),
      costmap_(config.costmap),
      planner_(config.planner, footprint.circumscribed_radius + config.margin),
      follower_(config.follower, footprint),
      recovery_(config.recovery),
      self_radius_(kSelf * footprint.inscribed_radius) {
  geometry::throwIfAny(config_.validate());
}

void Navigator::setMap(const grid::OccupancyGrid& map) {
  costmap_.setMap(map);
  map_changed_ = true;
  on_detour_ = false;  // it may show a shorter way
}

void Navigator::moveMap(const geometry::MapMotion& motion) { costmap_.moveTouched(motion); }

void Navigator::see(const Sighting& sighting, const geometry::Pose2& T_map_base) {
  if (!T_map_base.isFinite() || !std::isfinite(sighting.stamp)) {
    return;
  }
  costmap_.see(inMap(sighting, T_map_base, self_radius_), T_map_base.translation());
  seen_ = sighting.stamp;
  has_seen_ = true;
}

void Navigator::setGoal(const NavigationGoal& goal, double now) {
  cancel();
  goal_ = goal;
  complete_since_ = moved_at_ = nearer_at_ = now;
  least_left_ = std::numeric_limits<double>::infinity();
}

void Navigator::cancel() {
  goal_.reset();
  outcome_ = NavigationState::kIdle;
  reason_.clear();
  follower_.stop();
  recovery_.reset();
  recovering_ = blocked_ = in_contact_ = on_detour_ = false;
  detours_ = 0;
}

NavigatorStep Navigator::finish(NavigationState state, std::string reason) {
  cancel();  // and with it reason_, which `reason` may come from
  outcome_ = state;
  reason_ = std::move(reason);
  NavigatorStep result;
  result.state = state;
  result.reason = reason_;
  return result;
}

NavigatorStep Navigator::step(double now, const std::optional<geometry::StampedPose2>& T_map_base,
                              const motion::Twist2& velocity) {
  if (stepped_ && now < now_) {
    costmap_.forgetLive();
    has_seen_ = false;
    complete_since_ = moved_at_ = nearer_at_ = planned_at_ = now;
  }
  const double dt = stepped_ ? std::clamp(now - now_, kLeastStep, kLongestStep) : kLeastStep;
  stepped_ = true;
  now_ = now;
  costmap_.expire(now);
  velocity_ = presentVelocity(velocity, dt);
  NavigatorStep result;
  const std::string missing = missingInput(now, T_map_base);
  if (T_map_base && missing.empty()) {
    noteJump(T_map_base->pose, dt);
    complete_since_ = now;
  }
  if (!goal_) {
    result.state = outcome_;
    result.reason = reason_;
    result.velocity = follower_.brake(velocity_, dt);
  } else if (!missing.empty()) {
    result = wait(now, missing);
  } else if (in_contact_) {
    in_contact_ = false;
    recovery_.backOff(now, T_map_base->pose);
    recovering_ = true;
    turned_ = 0.0;
    reason_ = "The robot has bumped into something.";
    result = recover(T_map_base->pose, dt);
  } else {
    result = recovering_ ? recover(T_map_base->pose, dt) : drive(T_map_base->pose, dt);
  }
  command_ = result.velocity;
  return result;
}

motion::Twist2 Navigator::presentVelocity(const motion::Twist2& measured, double dt) const {
  if (!std::isfinite(measured.linear) || !std::isfinite(measured.angular)) {
    return command_;
  }
  // What was commanded last is where the base will be soon, unless it does something else.
  const FollowerConfig& limits = config_.follower;
  const bool obeys =
      std::abs(measured.linear - command_.linear) <= 2.5 * limits.max_linear_acceleration * dt &&
      std::abs(measured.angular - command_.angular) <= 2.5 * limits.max_angular_acceleration * dt;
  return obeys ? command_ : measured;
}

std::string Navigator::missingInput(double now,
                                    const std::optional<geometry::StampedPose2>& T_map_base) const {
  if (!costmap_.hasMap()) {
    return "There is no map.";
  }
  if (!T_map_base || !T_map_base->pose.isFinite()) {
    return "The robot's pose in the map is not known.";
  }
  if (now - T_map_base->stamp > config_.max_input_age) {
    return "The robot's pose in the map is too old.";
  }
  if (!has_seen_) {
    return "There is no scan.";
  }
  return now - seen_ > config_.max_input_age ? "The scan is too old." : "";
}

NavigatorStep Navigator::wait(double now, const std::string& what) {
  if (now - complete_since_ > config_.input_patience) {
    return finish(NavigationState::kFailed, what);
  }
  moved_at_ = nearer_at_ = now;  // it could not have moved
  NavigatorStep result;
  result.state = NavigationState::kWaiting;
  result.reason = what;
  return result;
}

void Navigator::noteJump(const geometry::Pose2& T_map_base, double dt) {
  if (last_pose_) {
    const double possible = config_.follower.max_linear_speed * dt + kJump;
    if (geometry::distance(*last_pose_, T_map_base) > possible) {
      costmap_.forgetSeen();  // it was seen from where the robot was believed to be
      map_changed_ = true;
    }
  }
  last_pose_ = T_map_base;
}

bool Navigator::restIsFree() const {
  const Path& path = follower_.path().path();
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    // What lies behind, and the way out of where it does not fit, is not looked at.
    const double skip = std::max(follower_.along(), refusal_.leave) - along;
    along += length;
    if (skip >= length) {
      continue;
    }
    const Eigen::Vector2d from =
        skip > 0.0 ? Eigen::Vector2d(path[i] + (path[i + 1] - path[i]) * (skip / length)) : path[i];
    if (!costmap_.isFree(from, path[i + 1], radius_)) {
      return false;
    }
  }
  return true;
}

bool Navigator::needsPlan() const {
  return follower_.path().empty() || follower_.offPath() > kOffPath || map_changed_ ||
         now_ - planned_at_ >= config_.replan_interval;
}

bool Navigator::replan(const geometry::Pose2& T_map_base) {
  planned_at_ = now_;
  map_changed_ = false;
  const bool is_on_path = !follower_.path().empty() && follower_.offPath() <= kOffPath;
  const bool keeps = is_on_path && restIsFree();
  Plan plan = planner_.plan(costmap_, T_map_base.translation(), goal_->position);
  if (!plan.found()) {
    refusal_ = plan;
    return keeps;
  }
  const ClearanceCost cost = planner_.cost();
  // What stood in a shorter way is forgotten before the detour is driven: to turn round then would
  // be to find it there once more.
  const bool is_better =
      !keeps || (!on_detour_ &&
                 cost.ofPath(costmap_, plan.path) <= kBetter * cost.ofPath(costmap_, restOfPath()));
  if (is_better) {
    take(plan, is_on_path && !keeps);
  }
  return true;
}

Path Navigator::restOfPath() const {
  const PathMeasure& old = follower_.path();
  Path rest{old.at(follower_.along())};
  for (double along = follower_.along() + 0.25; along < old.length(); along += 0.25) {
    rest.push_back(old.at(along));
  }
  rest.push_back(old.path().back());
  return rest;
}

void Navigator::take(const Plan& plan, bool old_is_blocked) {
  const double longer = lengthOf(plan.path) - (follower_.path().length() - follower_.along());
  on_detour_ = old_is_blocked && (on_detour_ || longer > kDetour);
  if (old_is_blocked && longer > kDetour && ++detours_ <= kMostDetours) {
    least_left_ = std::numeric_limits<double>::infinity();  // it comes nearer on this way now
  }
  refusal_ = {};
  refusal_.leave = plan.leave;
  follower_.follow(plan.path, goal_->heading);
}

NavigatorStep Navigator::drive(const geometry::Pose2& T_map_base, double dt) {
  if (needsPlan() && !replan(T_map_base)) {
    if (!refusal_.passing && refusal_.status != PlanStatus::kStartBlocked) {
      return finish(NavigationState::kFailed, refusal_.reason);
    }
    return trouble(refusal_.reason, T_map_base);
  }
  const FollowerStep follow = follower_.step(costmap_, T_map_base, velocity_, dt);
  if (follow.state == FollowState::kArrived) {
    return finish(NavigationState::kReached, "");
  }
  const bool was_blocked = blocked_;
  blocked_ = follow.state == FollowState::kBlocked;
  blocked_since_ = was_blocked ? blocked_since_ : now_;
  noteProgress(T_map_base, follow.left);
  if (blocked_ && now_ - blocked_since_ >= config_.blocked_time) {
    return trouble("Something stands in the way.", T_map_base);
  }
  if (now_ - moved_at_ >= config_.stall_time) {
    return trouble("The robot does not move.", T_map_base);
  }
  if (now_ - nearer_at_ >= config_.progress_time) {
    return trouble("The robot comes no nearer to the goal.", T_map_base);
  }
  NavigatorStep result;
  result.state = NavigationState::kDriving;
  result.velocity = follow.velocity;
  result.rollout = follow.rollout;
  result.left = follow.left;
  return result;
}

void Navigator::noteProgress(const geometry::Pose2& T_map_base, double left) {
  const double turn = std::abs(geometry::angleDifference(T_map_base.theta, moved_from_.theta));
  if (geometry::distance(T_map_base, moved_from_) > kMotion || turn > 4.0 * kMotion) {
    moved_from_ = T_map_base;
    moved_at_ = now_;
  }
  if (left < least_left_ - kNearer) {
    if (least_left_ < std::numeric_limits<double>::infinity()) {
      recovery_.reset();
    }
    least_left_ = left;
    nearer_at_ = now_;
  }
}

}  // namespace omega_slam::navigation
