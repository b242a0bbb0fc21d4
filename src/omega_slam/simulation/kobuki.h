#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/arc.h"
#include "omega_slam/motion/twist2.h"
#include "omega_slam/simulation/surroundings.h"

namespace omega_slam::simulation {

using motion::Arc;
using motion::Twist2;

/// Which of the three bumper switches at the front are pressed.
struct Bumper {
  bool left{false};
  bool centre{false};
  bool right{false};

  [[nodiscard]] bool any() const { return left || centre || right; }
  [[nodiscard]] bool operator==(const Bumper& other) const {
    return left == other.left && centre == other.centre && right == other.right;
  }
  [[nodiscard]] bool operator!=(const Bumper& other) const { return !(*this == other); }
};

/// Kobuki, the base of a TurtleBot 2. Speeds and sizes are the maker's; the accelerations are what
/// its velocity smoother usually allows.
struct KobukiConfig {
  double radius{0.177};                  ///< [m] of the round footprint
  double max_linear_speed{0.7};          ///< [m/s]
  double max_angular_speed{3.1416};      ///< [rad/s]
  double max_linear_acceleration{0.8};   ///< [m/s^2], also for braking
  double max_angular_acceleration{3.5};  ///< [rad/s^2], also for braking
  double command_timeout{0.6};  ///< [s] without a command, after which the base brakes to a stop

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// A differential drive on the floor of a world: true motion, no error, no clock.
///
/// Commanded speeds are reached at constant acceleration, and a step is the arc driven at the mean
/// of its first and last speed, so that straight acceleration is exact for any step.
/// A step that would lead into an obstacle ends where the footprint touches it: the base stands and
/// the bumper is pressed; turning on the spot and moving away stay possible. A contact behind the
/// middle stops the base but presses nothing: a Kobuki has no bumper there.
class Kobuki {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  explicit Kobuki(const KobukiConfig& config, const geometry::Pose2& T_world_base);

  /// Takes effect from the next step on; clamped to the speed limits.
  /// @return false, and nothing changes, if it is not finite
  [[nodiscard]] bool command(const Twist2& target);

  /// Drives for `dt` > 0 [s]. @return the arc that was truly driven
  Arc step(const Surroundings& surroundings, double dt);

  /// Carried by hand: stands at the pose, without command, bumper free.
  void place(const geometry::Pose2& T_world_base);

  [[nodiscard]] const geometry::Pose2& pose() const { return T_world_base_; }  ///< `T_world_base`
  [[nodiscard]] const Twist2& velocity() const { return velocity_; }
  [[nodiscard]] const Bumper& bumper() const { return bumper_; }
  [[nodiscard]] bool blocked() const { return blocked_; }  ///< an obstacle cut the last step short

 private:
  void accelerate(double dt);
  [[nodiscard]] double clearance(const Surroundings& surroundings,
                                 const geometry::Pose2& pose) const;
  [[nodiscard]] double freeShare(const Surroundings& surroundings, const Arc& arc) const;
  void updateBumper(const Surroundings& surroundings);

  KobukiConfig config_;
  geometry::Pose2 T_world_base_;
  Twist2 target_;
  Twist2 velocity_;
  double command_age_{0.0};
  bool blocked_{false};
  Bumper bumper_;
};

}  // namespace omega_slam::simulation
