#include "omega_slam/simulation/turtlebot.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {
namespace {

/// Independent streams of noise from one seed, so that a change to the laser leaves the odometry's
/// errors alone (SplitMix64, Steele et al. 2014).
std::uint64_t streamSeed(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t z = seed + stream * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

constexpr double kFarthestLaser = 10.0;  // [m] from the base; farther is a slip of the pen

enum Stream : std::uint64_t { kOdometryStream = 1, kLaserStream = 2 };

const TurtleBotConfig& checked(const TurtleBotConfig& config) {
  geometry::throwIfAny(config.validate());
  return config;
}

}  // namespace

std::vector<std::string> TurtleBotConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("time_step", time_step, 1e-4, 1.0);
  violations.requireWithin("start_time", start_time, 1e-3, 1e9);
  violations.requireWithin("laser_pose x", T_base_laser.x, -kFarthestLaser, kFarthestLaser);
  violations.requireWithin("laser_pose y", T_base_laser.y, -kFarthestLaser, kFarthestLaser);
  violations.requireWithin("laser_pose yaw", T_base_laser.theta, -10.0, 10.0);
  violations.requireWithin("hokuyo/rate * time_step", hokuyo.rate * time_step, 0.0, 1.0);
  violations.include("kobuki", kobuki.validate());
  violations.include("odometry", odometry.validate());
  violations.include("hokuyo", hokuyo.validate());
  return violations.sentences();
}

TurtleBot::TurtleBot(std::shared_ptr<const World> world, const geometry::Pose2& T_world_base,
                     const TurtleBotConfig& config)
    : config_(checked(config)),
      world_(std::move(world)),
      T_world_start_(T_world_base),
      kobuki_(config.kobuki, T_world_base),
      odometry_(config.odometry, streamSeed(config.seed, kOdometryStream)),
      hokuyo_(config.hokuyo, config.start_time, streamSeed(config.seed, kLaserStream)) {
  if (!T_world_base.isFinite() ||
      world_->nearestObstacle(T_world_base.translation(), config_.kobuki.radius)) {
    throw std::invalid_argument(
        fmt::format("The start pose ({:.2f}, {:.2f}) is in an obstacle or outside of the world.",
                    T_world_base.x, T_world_base.y));
  }
}

TurtleBotEvents TurtleBot::now() const {
  TurtleBotEvents events;
  events.odometry = {time(),
                     odometry_.pose(),
                     {odometry_.linearSpeed(), odometry_.angularSpeed()},
                     odometry_.leftWheel(),
                     odometry_.rightWheel()};
  events.truth = truth();
  return events;
}

TurtleBotEvents TurtleBot::step() {
  const geometry::StampedPose2 laser_before{time(), kobuki_.pose() * config_.T_base_laser};
  const Bumper bumper_before = kobuki_.bumper();
  const bool blocked_before = kobuki_.blocked();
  people_.step(config_.time_step, {kobuki_.pose().translation(), config_.kobuki.radius});
  const Surroundings surroundings(*world_, people_.discs());
  const Arc driven = kobuki_.step(surroundings, config_.time_step);
  odometry_.advance(driven, config_.time_step);
  ++steps_;
  if (kobuki_.blocked() && !blocked_before) {
    ++collisions_;
  }
  const geometry::StampedPose2 laser_after{time(), kobuki_.pose() * config_.T_base_laser};

  TurtleBotEvents events = now();
  events.scan = hokuyo_.sweep(surroundings, laser_before, laser_after);
  if (kobuki_.bumper() != bumper_before) {
    events.bumper = kobuki_.bumper();
  }
  return events;
}

void TurtleBot::resetPosition() { kobuki_.place(T_world_start_); }

double TurtleBot::time() const {
  return config_.start_time + static_cast<double>(steps_) * config_.time_step;
}

GroundTruth TurtleBot::truth() const { return {time(), kobuki_.pose(), kobuki_.velocity()}; }

}  // namespace omega_slam::simulation
