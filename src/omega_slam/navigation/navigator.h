#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/motion/twist2.h"
#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/follower.h"
#include "omega_slam/navigation/footprint.h"
#include "omega_slam/navigation/global_planner.h"
#include "omega_slam/navigation/recovery.h"

namespace omega_slam::navigation {

struct NavigatorConfig {
  CostmapConfig costmap;
  PlannerConfig planner;
  FollowerConfig follower;
  RecoveryConfig recovery;
  double margin{0.02};          ///< [m] that plans keep beyond the footprint
  double replan_interval{1.0};  ///< [s] after which it looks for a better way
  double max_input_age{0.5};    ///< [s] older poses and scans stop the robot
  double input_patience{10.0};  ///< [s] without pose, scan or map, after which a goal is given up
  double stall_time{4.0};       ///< [s] without motion, after which it is in trouble
  double progress_time{30.0};   ///< [s] without coming nearer to the goal, likewise
  double blocked_time{0.6};     ///< [s] that a blocked robot stands before that is trouble

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// Where to go, in the map's frame.
struct NavigationGoal {
  Eigen::Vector2d position{0.0, 0.0};  ///< [m]
  std::optional<double> heading;       ///< [rad] to arrive with; none: any
};

enum class NavigationState {
  kIdle,        ///< without a goal
  kDriving,     ///< along a plan
  kRecovering,  ///< out of trouble
  kWaiting,     ///< for a pose, a scan or a map: it stands
  kReached,     ///< the goal, which is over
  kFailed       ///< to reach the goal, which is over; there is a reason
};

struct NavigatorStep {
  NavigationState state{NavigationState::kIdle};
  motion::Twist2 velocity;  ///< to command
  std::string reason;       ///< why it waits, is in trouble or has failed
  RecoveryStage recovery{RecoveryStage::kNone};
  std::vector<geometry::Pose2> rollout;  ///< `T_map_base` that the command leads to
  double left{0.0};                      ///< [m] of the plan
};

/// What drives a robot to goals: plans, follows, and gets out of trouble. It is fed with what a
/// robot knows and says what to command: by a node on a robot, by function calls in a simulation.
/// It has no clock and no thread; the same input gives the same output, as long as OMPL is not cut
/// short by its time limit. Not thread-safe.
///
/// The robot is driven as a disc of its circumscribed radius. The command is to stand wherever
/// something is missing: no pose, no scan, no map, or too old ones.
class Navigator {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  Navigator(const NavigatorConfig& config, const Footprint& footprint);

  /// The newest map. Goals stay where they are in it.
  void setMap(const grid::OccupancyGrid& map);

  /// How keyframes have moved since the last time: what was touched moves with the one that was
  /// nearest to it, lest it stands in a door of the corrected map.
  void moveMap(const geometry::MapMotion& motion);

  /// The newest scan. @param sighting in the base frame, as it was at its stamp
  /// @param T_map_base at that stamp
  void see(const Sighting& sighting, const geometry::Pose2& T_map_base);

  /// Bumpers are pressed: by something that the laser doesn't see, so it is taken to be as wide as
  /// the robot, across the direction of the contact, or as the gap in a wall that it fills
  /// (grid::findPane()). May be called as long as they are pressed: that is one contact.
  /// @param points [m] of contact, in the base frame
  void touch(const std::vector<Eigen::Vector2d>& points, double now);

  /// A goal takes the place of the one before.
  void setGoal(const NavigationGoal& goal, double now);
  void cancel();
  [[nodiscard]] bool hasGoal() const { return goal_.has_value(); }
  [[nodiscard]] const std::optional<NavigationGoal>& goal() const { return goal_; }

  /// What to do now; to be called ten to twenty times a second, with a goal or without.
  /// @param now [s]; time that goes backwards forgets what was seen
  /// @param T_map_base the newest pose with its stamp; none: it is not known
  /// @param velocity as the odometry has it
  [[nodiscard]] NavigatorStep step(double now,
                                   const std::optional<geometry::StampedPose2>& T_map_base,
                                   const motion::Twist2& velocity);

  /// A plan without driving it.
  [[nodiscard]] Plan plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) const {
    return planner_.plan(costmap_, start, goal);
  }
  [[nodiscard]] Plan plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal,
                          double tolerance) const {
    return planner_.plan(costmap_, start, goal, tolerance);
  }

  void forgetObstacles() { costmap_.forgetLive(); }

  [[nodiscard]] const Costmap& costmap() const { return costmap_; }
  [[nodiscard]] const GlobalPlanner& planner() const { return planner_; }
  [[nodiscard]] const Path& path() const { return follower_.path().path(); }
  [[nodiscard]] double radius() const { return radius_; }  ///< [m] of the disc

 private:
  [[nodiscard]] std::string missingInput(
      double now, const std::optional<geometry::StampedPose2>& T_map_base) const;
  [[nodiscard]] NavigatorStep wait(double now, const std::string& what);
  [[nodiscard]] NavigatorStep drive(const geometry::Pose2& T_map_base, double dt);
  [[nodiscard]] NavigatorStep recover(const geometry::Pose2& T_map_base, double dt);
  [[nodiscard]] NavigatorStep trouble(const std::string& reason, const geometry::Pose2& T_map_base);
  [[nodiscard]] NavigatorStep finish(NavigationState state, std::string reason);
  [[nodiscard]] bool needsPlan() const;
  /// Whether there is a path to follow now; if not, the reason is in refusal_.
  [[nodiscard]] bool replan(const geometry::Pose2& T_map_base);
  [[nodiscard]] bool restIsFree() const;
  [[nodiscard]] Path restOfPath() const;
  /// Begins to follow a plan that takes the place of one that is no longer free, if there was one.
  void take(const Plan& plan, bool old_is_blocked);
  void noteProgress(const geometry::Pose2& T_map_base, double left);
  void noteJump(const geometry::Pose2& T_map_base, double dt);
  [[nodiscard]] motion::Twist2 presentVelocity(const motion::Twist2& measured, double dt) const;

  NavigatorConfig config_;
  double radius_;
  Costmap costmap_;
  GlobalPlanner planner_;
  Follower follower_;
  Recovery recovery_;
  double self_radius_;  ///< [m] what is seen in there is the robot itself

  std::optional<NavigationGoal> goal_;
  NavigationState outcome_{NavigationState::kIdle};  ///< of the last goal
  std::string reason_;                               ///< of the last trouble
  Plan refusal_;
  bool map_changed_{false};
  bool in_contact_{false};  ///< since the last step
  bool recovering_{false};
  double turned_{0.0};     ///< [rad] since the stage of recovery began
  bool on_detour_{false};  ///< around what stood in a shorter way, and may be forgotten by now
  int detours_{0};         ///< that were begun on the way to the goal

  double now_{0.0};
  bool stepped_{false};
  motion::Twist2 command_;
  motion::Twist2 velocity_;
  double seen_{0.0};  ///< [s] stamp of the newest scan
  bool has_seen_{false};
  std::optional<geometry::Pose2> last_pose_;
  std::optional<double> touched_at_;  ///< [s] when bumpers were pressed last
  std::optional<double> contact_at_;  ///< [s] when that began, or was taken to
  double complete_since_{0.0};        ///< [s] when last all input was there
  double planned_at_{0.0};
  double moved_at_{0.0};
  geometry::Pose2 moved_from_;
  double nearer_at_{0.0};
  double least_left_{0.0};  ///< [m]
  double blocked_since_{0.0};
  bool blocked_{false};
};

}  // namespace omega_slam::navigation
