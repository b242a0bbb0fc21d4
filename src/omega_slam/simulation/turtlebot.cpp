#include "omega_slam/simulation/turtlebot.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "omega_slam/simulation/validation.h"

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

enum Stream : std::uint64_t { kOdometryStream = 1, kLaserStream = 2 };

void append(std::vector<std::string>& sentences, const std::string& group,
            const std::vector<std::string>& violations) {
  for (const std::string& violation : violations) {
    sentences.push_back(group + "/" + violation);
  }
}

const TurtleBotConfig& checked(const TurtleBotConfig& config) {
  throwIfAny(config.validate());
  return config;
}

}  // namespace

std::vector<std::string> TurtleBotConfig::validate() const {
  Violations violations;
  violations.requirePositive("time_step", time_step);
  violations.requirePositive("start_time", start_time);
  violations.require(T_base_laser.isFinite(), "laser_pose must be finite.");
  violations.require(!(hokuyo.rate * time_step > 1.0),
                     "hokuyo/rate must be at most one scan for each time_step.");
  std::vector<std::string> sentences = violations.sentences();
  append(sentences, "kobuki", kobuki.validate());
  append(sentences, "odometry", odometry.validate());
  append(sentences, "hokuyo", hokuyo.validate());
  return sentences;
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

TurtleBotEvents TurtleBot::step() {
  const geometry::StampedPose2 laser_before{time(), kobuki_.pose() * config_.T_base_laser};
  const Bumper bumper_before = kobuki_.bumper();
  const bool blocked_before = kobuki_.blocked();
  const Arc driven = kobuki_.step(*world_, config_.time_step);
  odometry_.advance(driven, config_.time_step);
  ++steps_;
  if (kobuki_.blocked() && !blocked_before) {
    ++collisions_;
  }
  const geometry::StampedPose2 laser_after{time(), kobuki_.pose() * config_.T_base_laser};

  TurtleBotEvents events;
  events.odometry = {time(),
                     odometry_.pose(),
                     {odometry_.linearSpeed(), odometry_.angularSpeed()},
                     odometry_.leftWheel(),
                     odometry_.rightWheel()};
  events.truth = truth();
  events.scan = hokuyo_.sweep(*world_, laser_before, laser_after);
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
