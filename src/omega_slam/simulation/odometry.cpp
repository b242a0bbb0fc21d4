#include "omega_slam/simulation/odometry.h"

#include <cmath>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {
namespace {

constexpr double kTimeSlack = 1e-9;  // [s] rounding of summed time steps

void turnWheel(Odometry::Wheel& wheel, double angle, double dt) {
  wheel.angle += angle;
  wheel.speed = angle / dt;
}

}  // namespace

std::vector<std::string> OdometryConfig::validate() const {
  geometry::Violations violations;
  violations.include("noise", noise.validate());
  violations.requireAbove("segment", segment, 0.0);
  violations.requireAbove("wheel_separation", wheel_separation, 0.0);
  violations.requireAbove("wheel_radius", wheel_radius, 0.0);
  return violations.sentences();
}

OdometryConfig withNoise(OdometryConfig config, double factor) {
  config.noise.rotation_per_rotation *= factor;
  config.noise.rotation_per_translation *= factor;
  config.noise.translation_per_translation *= factor;
  config.noise.translation_per_rotation *= factor;
  return config;
}

Odometry::Odometry(const OdometryConfig& config, std::uint64_t seed)
    : config_(config), random_(seed) {
  geometry::throwIfAny(config_.validate());
}

void Odometry::advance(const Arc& driven, double dt) {
  if (segment_left_ < kTimeSlack) {
    drawErrors();
    segment_left_ = config_.segment;
  }
  segment_left_ -= dt;
  const Arc felt{
      driven.length * (1.0 + length_per_length_) + std::abs(driven.turn) * length_per_turn_,
      driven.turn * (1.0 + turn_per_turn_) + driven.length * turn_per_length_};
  T_odom_base_ = T_odom_base_ * felt.toMotion();
  linear_speed_ = felt.length / dt;
  angular_speed_ = felt.turn / dt;
  const double difference = 0.5 * config_.wheel_separation * felt.turn;
  turnWheel(left_, (felt.length - difference) / config_.wheel_radius, dt);
  turnWheel(right_, (felt.length + difference) / config_.wheel_radius, dt);
}

void Odometry::reset() {
  T_odom_base_ = {};
  left_.angle = right_.angle = 0.0;
}

void Odometry::drawErrors() {
  const motion::OdometryMotionModelConfig& noise = config_.noise;
  length_per_length_ = noise.translation_per_translation * normal_(random_);
  length_per_turn_ = noise.translation_per_rotation * normal_(random_);
  turn_per_turn_ = noise.rotation_per_rotation * normal_(random_);
  turn_per_length_ = std::sqrt(2.0) * noise.rotation_per_translation * normal_(random_);
}

}  // namespace omega_slam::simulation
