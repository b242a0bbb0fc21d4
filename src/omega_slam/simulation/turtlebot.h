#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/kobuki.h"
#include "omega_slam/simulation/odometry.h"
#include "omega_slam/simulation/people.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::simulation {

struct TurtleBotConfig {
  KobukiConfig kobuki;
  OdometryConfig odometry;
  HokuyoConfig hokuyo;
  geometry::Pose2 T_base_laser{0.10, 0.0, 0.0};  ///< where the laser sits; the URDF says the same
  double time_step{0.02};  ///< [s] of the physics and between odometry samples: 50 Hz as Kobuki
  double start_time{1.0};  ///< [s] time before the first step; above 0, which ROS reads as "unset"
  std::uint64_t seed{1};   ///< of all noise

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// What the base reports after a step.
struct OdometrySample {
  double stamp{0.0};  ///< [s]
  geometry::Pose2 T_odom_base;
  Twist2 velocity;  ///< as the wheels have it, errors included
  Odometry::Wheel left;
  Odometry::Wheel right;
};

/// What only a simulator knows.
struct GroundTruth {
  double stamp{0.0};  ///< [s]
  geometry::Pose2 T_world_base;
  Twist2 velocity;
};

/// All that a moment brings.
struct TurtleBotEvents {
  OdometrySample odometry;
  GroundTruth truth;
  std::optional<sensing::LaserScan> scan;  ///< finished during the step; stamped at its first beam
  std::optional<Bumper> bumper;            ///< if it changed
};

/// A TurtleBot 2 with a Hokuyo in a world. It has no clock: time passes only in step(), and the
/// same seed and commands give the same output to the last bit. Not thread-safe.
class TurtleBot {
 public:
  /// @param T_world_base where it starts, standing still
  /// @throws std::invalid_argument if the configuration is not valid or the start is in an obstacle
  TurtleBot(std::shared_ptr<const World> world, const geometry::Pose2& T_world_base,
            const TurtleBotConfig& config);

  /// @return false, and nothing changes, if the command is not finite
  [[nodiscard]] bool command(const Twist2& velocity) { return kobuki_.command(velocity); }

  /// Odometry and truth as they are now: what is said before the first step, so that the first
  /// scan, whose sweep begins with it, has an odometry to begin with.
  [[nodiscard]] TurtleBotEvents now() const;

  /// Lets `config.time_step` pass.
  TurtleBotEvents step();

  /// Carries the robot back to its start. Odometry and time know nothing of it, as when a person
  /// lifts the robot (and as stage_ros's service of this name).
  void resetPosition();

  /// Odometry back to zero, as the base does on command.
  void resetOdometry() { odometry_.reset(); }

  /// Lets people walk about it from now on.
  void meet(People people) { people_ = std::move(people); }
  [[nodiscard]] const People& people() const { return people_; }

  [[nodiscard]] double time() const;        ///< [s]
  [[nodiscard]] GroundTruth truth() const;  ///< now
  [[nodiscard]] const Bumper& bumper() const { return kobuki_.bumper(); }
  [[nodiscard]] int collisions() const { return collisions_; }  ///< times that it bumped so far
  [[nodiscard]] const TurtleBotConfig& config() const { return config_; }

 private:
  TurtleBotConfig config_;
  std::shared_ptr<const World> world_;
  People people_;
  geometry::Pose2 T_world_start_;
  Kobuki kobuki_;
  Odometry odometry_;
  Hokuyo hokuyo_;
  std::uint64_t steps_{0};
  int collisions_{0};
};

}  // namespace omega_slam::simulation
