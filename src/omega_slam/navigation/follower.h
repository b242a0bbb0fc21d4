#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/twist2.h"
#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/footprint.h"
#include "omega_slam/navigation/path.h"

namespace omega_slam::navigation {

struct FollowerConfig {
  double max_linear_speed{0.5};          ///< [m/s]
  double max_angular_speed{1.5};         ///< [rad/s]
  double max_linear_acceleration{0.5};   ///< [m/s^2], also for braking
  double max_angular_acceleration{2.5};  ///< [rad/s^2], also for braking
  double horizon{1.2};                   ///< [s] for which a turn lasts, then straight on
  double look_ahead{0.5};                ///< [m] it steers for a point so far ahead on the path
  double turn_in_place_angle{0.9};       ///< [rad] farther off course, it stops and turns first
  double clearance_time{0.2};  ///< [s] room wanted beyond the footprint, per speed: slower where it
                               ///< is tight
  double position_tolerance{0.10};  ///< [m] the goal is reached from this distance
  double heading_tolerance{0.15};   ///< [rad]
  int linear_samples{6};            ///< speeds that are tried at each step
  int angular_samples{21};

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

enum class FollowState {
  kDriving,
  kTurning,  ///< on the spot
  kBlocked,  ///< no motion would be safe that leads on
  kArrived
};

/// What to do now.
struct FollowerStep {
  FollowState state{FollowState::kArrived};
  motion::Twist2 velocity;               ///< to command
  std::vector<geometry::Pose2> rollout;  ///< `T_map_base` that the command leads to, step by step
  double left{0.0};                      ///< [m] of the path
};

/// Drives a differential robot along a path with the dynamic window approach (Fox, Burgard and
/// Thrun, "The Dynamic Window Approach to Collision Avoidance", 1997): of the velocities that can
/// be reached until the next step, those are admissible whose arc stays clear of the map's
/// obstacles and of what is seen, and the one that leads on best along the path is commanded.
/// Deviations: a motion is looked at as far ahead whatever its speed, as an arc for the horizon and
/// then straight on, so that a slow robot sees a dead end as well as a fast one; it is scored by
/// speed, by the progress of its clear part along the path, and by that part's room, distance from
/// the path and course, not by heading to the goal; and the room that it must have grows with its
/// speed. Where the path leads off sharply, the robot turns on the spot.
///
/// A robot that already stands nearer to something than its radius may move where it does not come
/// nearer, but never so near to what it sees that its base would touch it. Not thread-safe.
class Follower {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  Follower(const FollowerConfig& config, const Footprint& footprint);

  /// @param path [m] in the map; @param heading [rad] to turn to at its end, if any
  void follow(const Path& path, std::optional<double> heading);
  void stop() { path_ = {}; }

  /// @param T_map_base where it is; @param velocity as it moves now; @param dt [s] to the next step
  [[nodiscard]] FollowerStep step(const Costmap& costmap, const geometry::Pose2& T_map_base,
                                  const motion::Twist2& velocity, double dt);

  [[nodiscard]] const PathMeasure& path() const { return path_; }
  [[nodiscard]] double along() const { return along_; }  ///< [m] of the path are done
  /// [m] from the path, at the last step
  [[nodiscard]] double offPath() const { return off_path_; }

  /// Turning on the spot by an angle [rad], as fast as can be stopped in time.
  [[nodiscard]] motion::Twist2 turn(double angle, const motion::Twist2& velocity, double dt) const;
  /// As slow as braking allows.
  [[nodiscard]] motion::Twist2 brake(const motion::Twist2& velocity, double dt) const;
  /// Whether a straight drive [m], negative backwards, stays clear.
  [[nodiscard]] bool isClearStraight(const Costmap& costmap, const geometry::Pose2& T_map_base,
                                     double distance) const;

  [[nodiscard]] const FollowerConfig& config() const { return config_; }

 private:
  /// Velocities within reach until the next step.
  struct Window {
    double slowest, fastest;  ///< [m/s]
    double right, left;       ///< [rad/s]
  };
  [[nodiscard]] FollowerStep arrive(const geometry::Pose2& T_map_base,
                                    const motion::Twist2& velocity, double dt);
  [[nodiscard]] FollowerStep choose(const Costmap& costmap, const geometry::Pose2& T_map_base,
                                    const motion::Twist2& velocity, double dt) const;
  [[nodiscard]] Window windowAbout(const geometry::Pose2& T_map_base,
                                   const motion::Twist2& velocity, double dt) const;
  /// What a motion would lead to, as far as it is clear.
  struct Outlook {
    std::vector<geometry::Pose2> arc;  ///< `T_map_base`, step by step
    double reach{0.0};                 ///< [m] that was looked at
    double clear{0.0};                 ///< [m] of it are clear
    double room{0.0};                  ///< [m] least clearance on the clear part
  };
  /// What the robot must keep: its radius of room, or where it has less, as much as it has. That
  /// may be a map's error, in step after step it can become less, and what it allows is allowed
  /// anywhere; so the base keeps its own radius off what is seen, whatever the map shows.
  [[nodiscard]] Costmap::Room leastRoom(const Costmap::Room& here) const;
  [[nodiscard]] Outlook lookAlong(const Costmap& costmap, const geometry::Pose2& T_map_base,
                                  const motion::Twist2& velocity) const;
  /// [m/s] that the robot may have where there is so much room [m].
  [[nodiscard]] double speedWithin(double room) const;
  /// @param present [m/s] speed; @param dt [s] to the next step
  [[nodiscard]] bool isAdmissible(const Outlook& outlook, double speed, double present,
                                  double dt) const;
  [[nodiscard]] double score(const Outlook& outlook, double speed) const;
  [[nodiscard]] double courseError(const geometry::Pose2& pose, double along) const;

  FollowerConfig config_;
  double radius_;       ///< [m] circumscribed
  double base_radius_;  ///< [m] inscribed
  PathMeasure path_;
  std::optional<double> heading_;
  double along_{0.0};
  double off_path_{0.0};
  bool turning_{false};
  bool at_end_{false};
};

}  // namespace omega_slam::navigation
