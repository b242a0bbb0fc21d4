#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/simulation/kobuki.h"

namespace omega_slam::simulation {

struct RouteDriverConfig {
  double max_linear_speed{0.45};    ///< [m/s]
  double max_angular_speed{1.2};    ///< [rad/s]
  double deceleration{0.5};         ///< [m/s^2] with which it slows down for corners
  double corner_speed{0.20};        ///< [m/s] through a sharp corner
  double turn_in_place_angle{0.6};  ///< [rad] farther off course, it stops and turns first
  double look_ahead{0.35};          ///< [m] it steers for a point so far ahead on the route
  double waypoint_tolerance{0.10};  ///< [m] a waypoint is reached from this distance
  double stall_time{1.5};           ///< [s] with a command but without motion: it has bumped
  double back_off_distance{0.25};   ///< [m] it backs off after a bump
  double back_off_speed{0.15};      ///< [m/s]
  int max_bumps{3};                 ///< bumps on the way to one waypoint before it gives up

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// How far the drive has come.
struct RouteStatus {
  enum class State { kDriving, kDone, kStuck };
  State state{State::kDriving};
  std::size_t next{0};   ///< index of the waypoint that it drives to
  std::size_t count{0};  ///< waypoints of the route
  std::string reason;    ///< why it is stuck, one phrase

  /// "driving k/n", "done" or "stuck: reason".
  [[nodiscard]] std::string toString() const;
};

/// The person with the joystick: drives a robot, whose true pose he sees, along straight lines from
/// waypoint to waypoint. Turns on the spot where the course is far off, slows down for corners,
/// backs off from what it bumped into, and gives up with a reason.
class RouteDriver {
 public:
  /// @param route waypoints [m] in the world; empty: done at once
  /// @throws std::invalid_argument if the configuration is not valid or a waypoint is not finite
  RouteDriver(const RouteDriverConfig& config, std::vector<Eigen::Vector2d> route);

  /// The command for now. Time that goes backwards forgets what was seen before, but not the
  /// waypoint.
  /// @param now [s]; @param T_world_base true and finite
  [[nodiscard]] Twist2 update(double now, const geometry::Pose2& T_world_base);

  [[nodiscard]] RouteStatus status() const;

 private:
  void passReachedWaypoints(const Eigen::Vector2d& position);
  void watchForBumps(double now, const geometry::Pose2& T_world_base);
  [[nodiscard]] bool isReached(const Eigen::Vector2d& position) const;
  [[nodiscard]] bool isBackingOff(const Eigen::Vector2d& position, double now) const;
  [[nodiscard]] Eigen::Vector2d steeringPoint(const Eigen::Vector2d& position) const;
  [[nodiscard]] double cornerSpeed() const;
  [[nodiscard]] Twist2 drive(const geometry::Pose2& T_world_base) const;

  RouteDriverConfig config_;
  std::vector<Eigen::Vector2d> route_;
  std::size_t next_{0};
  Eigen::Vector2d leg_start_{0.0, 0.0};
  bool started_{false};
  std::string stuck_reason_;

  double last_progress_{0.0};      ///< [s] when it last stood elsewhere
  geometry::Pose2 progress_pose_;  ///< where it stood then
  double back_off_until_{0.0};     ///< [s] end of backing off at the latest
  Eigen::Vector2d bump_position_{0.0, 0.0};
  bool backing_off_{false};
  int bumps_{0};
  double last_update_{0.0};
};

}  // namespace omega_slam::simulation
