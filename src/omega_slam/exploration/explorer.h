#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/exploration/explorer_config.h"
#include "omega_slam/exploration/fast_detector.h"
#include "omega_slam/exploration/set_aside_list.h"
#include "omega_slam/exploration/strategy.h"
#include "omega_slam/exploration/survey.h"
#include "omega_slam/exploration/wall_follower.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::exploration {

enum class Phase : std::uint8_t { kIdle, kExploring, kPaused, kReturning, kEnded };
enum class Ending : std::uint8_t { kNone, kDone, kStopped, kBudget, kStuck };

[[nodiscard]] const char* toString(Phase phase);
[[nodiscard]] const char* toString(Ending ending);

/// A sweep that has come into the map, and where it was drawn.
struct PlacedSweep {
  const sensing::Sweep* sweep{nullptr};
  geometry::Pose2 T_map_base;
};

struct Goal {
  std::uint64_t id{0};
  geometry::Pose2 T_map_base;
  FrontierId frontier{0};  ///< 0: none, on the way home or along a wall
};

/// What whoever drives the robot is to do now.
struct Order {
  enum class Kind : std::uint8_t { kKeepOn, kGo, kCancel };
  Kind kind{Kind::kKeepOn};
  Goal goal;  ///< where to go
};

struct Progress {
  double share{0.0};         ///< [0, 1] known area of it and of what lies behind the frontiers
  double distance{0.0};      ///< [m] driven since the start
  double time{0.0};          ///< [s] since the start, without pauses
  std::size_t frontiers{0};  ///< that can be reached and are worth it
  std::size_t goals{0};      ///< given so far
};

/// The answer to somebody who wants something.
struct Reply {
  bool success{false};
  std::string message;  ///< one sentence
};

/// The life of an exploration, from start to end. It is fed the map, the robot's pose and what
/// became of its goals, and answers with goals; it knows nothing of who drives. Poses are in the
/// map frame. Deterministic. Not thread-safe.
///
/// It ends for a reason and not by accident: without a pose nothing changes; before it is done, the
/// whole map is searched for frontiers once more, and those set aside are tried again.
class Explorer {
 public:
  explicit Explorer(const ExplorerConfig& config = {});  ///< @throws std::invalid_argument

  Reply start();
  Reply stop();
  Reply pause();
  Reply resume();
  Reply setStrategy(const std::string& name);

  /// The map as it is now.
  /// @param news the sweeps that it has and the last one had not. With none, as where they are not
  /// known, the whole map is searched.
  /// @param motion how keyframes have moved since the last map, if they have: the map was drawn
  /// anew, and goals, home and what is set aside move with it
  void showMap(std::shared_ptr<const grid::OccupancyGrid> map,
               const std::vector<PlacedSweep>& news = {},
               const geometry::MapMotion* motion = nullptr);

  /// Bumpers are pressed: what the laser does not see, no way leads through.
  /// @param contacts [m] in the base frame, where the robot was last
  void touch(const std::vector<Eigen::Vector2d>& contacts);

  /// To be called a few times a second.
  /// @param now [s]; @param T_map_base none while nobody knows it
  [[nodiscard]] Order update(double now, const std::optional<geometry::Pose2>& T_map_base);

  /// What became of a goal; of one that is no longer the newest, nothing is heard.
  void goalEnded(std::uint64_t id, bool reached);

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] Ending ending() const { return ending_; }
  [[nodiscard]] const std::string& reason() const {
    return reason_;
  }  ///< of the ending, a sentence
  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] const std::string& strategy() const { return config_.strategy; }
  [[nodiscard]] const std::optional<Goal>& goal() const { return goal_; }
  [[nodiscard]] const FrontierStore::Frontiers& frontiers() const {
    return detector_.store().all();
  }
  [[nodiscard]] const std::vector<SetAside>& setAside() const { return set_aside_.entries(); }

 private:
  /// Where the goal stands.
  enum class GoalState : std::uint8_t { kNone, kDriving, kReached, kFailed };

  void account(double now, const std::optional<geometry::Pose2>& T_map_base);
  void moveAlong(const geometry::MapMotion& motion, const MapView& old);
  [[nodiscard]] Survey surveyFrom(const geometry::Pose2& T_map_base) const;
  /// Along a wall; steps are so short that the robot would stand most of the time.
  [[nodiscard]] bool isStepDone() const;
  [[nodiscard]] bool isDecisionDue(double now) const;
  Order decide(double now, const geometry::Pose2& T_map_base);
  void judgeGoal(double now);
  void watchApproach(const Survey& survey, double now);
  [[nodiscard]] bool isWorthwhile(const Survey& survey) const;
  [[nodiscard]] bool isStillTheBest(const Viewpoint& other, const Frontier& frontier,
                                    const Survey& survey) const;
  [[nodiscard]] std::vector<Option> optionsNow(const Survey& survey, double now) const;
  [[nodiscard]] std::vector<Option> optionsAtAll(const Survey& survey, double now);
  [[nodiscard]] bool isInArea(const Eigen::Vector2d& point) const;
  void measureProgress(const Survey& survey, const std::vector<Option>& options);
  Order choose(const Survey& survey, const std::vector<Option>& options,
               const geometry::Pose2& T_map_base);
  Order stepAlongWall(const Survey& survey, const geometry::Pose2& T_map_base);
  Order goTo(const geometry::Pose2& T_map_goal, FrontierId frontier);
  [[nodiscard]] std::string spentBudget() const;
  Order whenNothingIsLeft();
  Order endExploring(Ending ending, std::string reason);
  Order cancel();
  [[nodiscard]] bool isAnythingLeft(double now, const geometry::Pose2& T_map_base);
  Order comeHome(double now, const geometry::Pose2& T_map_base);
  /// Home, or the nearest place to it where the map shows room.
  [[nodiscard]] geometry::Pose2 placeAtHome(const geometry::Pose2& T_map_base) const;
  [[nodiscard]] bool isNearerHome(const geometry::Pose2& place, const Goal& goal) const;
  Order end(const std::string& addition);
  void dropGoal();

  ExplorerConfig config_;
  std::unique_ptr<const Strategy> strategy_;  ///< null: wall following
  WallFollower wall_follower_;
  FastDetector detector_;
  SetAsideList set_aside_;
  std::shared_ptr<const grid::OccupancyGrid> map_;
  std::vector<Eigen::Vector2d> touched_;  ///< [m] map frame

  Phase phase_{Phase::kIdle};
  Phase paused_phase_{Phase::kIdle};  ///< that goes on after the pause
  Ending ending_{Ending::kNone};
  std::string reason_;
  Progress progress_;
  std::optional<geometry::Pose2> home_;
  std::optional<geometry::Pose2> last_pose_;
  std::optional<double> last_now_;

  std::optional<Goal> goal_;
  GoalState goal_state_{GoalState::kNone};
  bool goal_moved_{false};               ///< with the map: to be given once more
  bool cancel_is_due_{false};            ///< the driver does not know yet that its goal is no more
  std::optional<double> goal_ended_;     ///< [s]
  double least_left_{0.0};               ///< [m] of the way to the goal, so far
  double nearer_at_{0.0};                ///< [s] when that was
  std::optional<double> last_decision_;  ///< [s]
  std::optional<std::uint64_t> driven_;  ///< the goal that the driver has
  bool map_is_new_{false};               ///< since the last decision
  std::uint64_t next_goal_{1};
  int failures_{0};  ///< goals in a row that were not reached
};

}  // namespace omega_slam::exploration
