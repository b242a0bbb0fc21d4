#include "omega_slam/simulation/kobuki.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {
namespace {

constexpr double kTimeSlack = 1e-9;      // [s] rounding of summed time steps
constexpr double kDistanceSlack = 1e-9;  // [m] rounding of distances
constexpr double kBumperTravel = 0.005;  // [m] a pressed switch lets go once there is so much room
constexpr int kContactBisections = 20;   // a step of centimetres is cut to well below a micron
constexpr double kCentreHalfAngle = geometry::kPi / 6.0;  // the centre switch covers 60 degrees
constexpr double kFrontHalfAngle = geometry::kPi / 2.0;   // the bumper covers the front half

double approach(double value, double target, double max_change) {
  return value + std::clamp(target - value, -max_change, max_change);
}

Bumper pressedFrom(double bearing) {
  Bumper bumper;
  if (std::abs(bearing) <= kCentreHalfAngle) {
    bumper.centre = true;
  } else if (std::abs(bearing) <= kFrontHalfAngle) {
    (bearing > 0.0 ? bumper.left : bumper.right) = true;
  }
  return bumper;
}

}  // namespace

std::vector<std::string> KobukiConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("radius", radius, 0.0);
  violations.requireAbove("max_linear_speed", max_linear_speed, 0.0);
  violations.requireAbove("max_angular_speed", max_angular_speed, 0.0);
  violations.requireAbove("max_linear_acceleration", max_linear_acceleration, 0.0);
  violations.requireAbove("max_angular_acceleration", max_angular_acceleration, 0.0);
  violations.requireAbove("command_timeout", command_timeout, 0.0);
  return violations.sentences();
}

Kobuki::Kobuki(const KobukiConfig& config, const geometry::Pose2& T_world_base)
    : config_(config), T_world_base_(T_world_base) {
  geometry::throwIfAny(config_.validate());
}

bool Kobuki::command(const Twist2& target) {
  if (!std::isfinite(target.linear) || !std::isfinite(target.angular)) {
    return false;
  }
  target_.linear = std::clamp(target.linear, -config_.max_linear_speed, config_.max_linear_speed);
  target_.angular =
      std::clamp(target.angular, -config_.max_angular_speed, config_.max_angular_speed);
  command_age_ = 0.0;
  return true;
}

Arc Kobuki::step(const Surroundings& surroundings, double dt) {
  const Twist2 before = velocity_;
  accelerate(dt);
  Arc arc{0.5 * (before.linear + velocity_.linear) * dt,
          0.5 * (before.angular + velocity_.angular) * dt};
  const double share = freeShare(surroundings, arc);
  blocked_ = share < 1.0;
  if (blocked_) {
    arc.length *= share;
    velocity_.linear = 0.0;
  }
  T_world_base_ = T_world_base_ * arc.toMotion();
  updateBumper(surroundings);
  return arc;
}

void Kobuki::place(const geometry::Pose2& T_world_base) {
  T_world_base_ = T_world_base;
  target_ = velocity_ = {};
  blocked_ = false;
  bumper_ = {};
}

void Kobuki::accelerate(double dt) {
  if (command_age_ >= config_.command_timeout - kTimeSlack) {
    target_ = {};
  }
  command_age_ += dt;
  velocity_.linear =
      approach(velocity_.linear, target_.linear, config_.max_linear_acceleration * dt);
  velocity_.angular =
      approach(velocity_.angular, target_.angular, config_.max_angular_acceleration * dt);
}

double Kobuki::clearance(const Surroundings& surroundings, const geometry::Pose2& pose) const {
  const auto obstacle = surroundings.nearestObstacle(pose.translation(), config_.radius);
  return obstacle ? (*obstacle - pose.translation()).norm() : config_.radius;
}

double Kobuki::freeShare(const Surroundings& surroundings, const Arc& arc) const {
  // A base that already touches may move as long as it does not come nearer.
  const double needed =
      std::min(clearance(surroundings, T_world_base_), config_.radius - kDistanceSlack);
  const auto isFree = [&](double share) {
    const Arc part{share * arc.length, arc.turn};
    return clearance(surroundings, T_world_base_ * part.toMotion()) >= needed;
  };
  if (isFree(1.0)) {
    return 1.0;
  }
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kContactBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (isFree(middle) ? low : high) = middle;
  }
  return low;
}

void Kobuki::updateBumper(const Surroundings& surroundings) {
  if (!blocked_ && !bumper_.any()) {
    return;
  }
  const auto contact =
      surroundings.nearestObstacle(T_world_base_.translation(), config_.radius + kBumperTravel);
  if (!contact) {
    bumper_ = {};
    return;
  }
  const Eigen::Vector2d p_base = T_world_base_.inverse() * *contact;
  bumper_ = pressedFrom(std::atan2(p_base.y(), p_base.x()));
}

}  // namespace omega_slam::simulation
