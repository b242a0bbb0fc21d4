// The life of an Explorer: from start to end, and what somebody asks of it on the way.
#include <fmt/format.h>

#include <cmath>

#include "omega_slam/exploration/explorer.h"
#include "omega_slam/exploration/strategy_factory.h"

namespace omega_slam::exploration {

using geometry::Pose2;

const char* toString(Phase phase) {
  switch (phase) {
    case Phase::kIdle:
      return "idle";
    case Phase::kExploring:
      return "exploring";
    case Phase::kPaused:
      return "paused";
    case Phase::kReturning:
      return "returning";
    case Phase::kEnded:
      return "ended";
  }
  return "";
}

const char* toString(Ending ending) {
  switch (ending) {
    case Ending::kNone:
      return "none";
    case Ending::kDone:
      return "done";
    case Ending::kStopped:
      return "stopped";
    case Ending::kBudget:
      return "budget";
    case Ending::kStuck:
      return "stuck";
  }
  return "";
}

Reply Explorer::start() {
  if (phase_ != Phase::kIdle && phase_ != Phase::kEnded) {
    return {false, fmt::format("The exploration is {} already.", toString(phase_))};
  }
  dropGoal();
  set_aside_.clear();
  touched_.clear();
  progress_ = {};
  home_.reset();
  last_pose_.reset();
  failures_ = 0;
  ending_ = Ending::kNone;
  reason_.clear();
  phase_ = Phase::kExploring;
  return {true, "The exploration has begun."};
}

Reply Explorer::stop() {
  if (phase_ == Phase::kIdle || phase_ == Phase::kEnded) {
    return {false, "There is no exploration to stop."};
  }
  cancel_is_due_ = driven_.has_value();
  dropGoal();
  ending_ = Ending::kStopped;
  reason_ = "It was stopped.";
  phase_ = Phase::kEnded;
  return {true, "The exploration was stopped."};
}

Reply Explorer::pause() {
  if (phase_ != Phase::kExploring && phase_ != Phase::kReturning) {
    return {false,
            fmt::format("The exploration is {}: there is nothing to pause.", toString(phase_))};
  }
  cancel_is_due_ = driven_.has_value();
  dropGoal();
  paused_phase_ = phase_;
  phase_ = Phase::kPaused;
  return {true, "The exploration pauses."};
}

Reply Explorer::resume() {
  if (phase_ != Phase::kPaused) {
    return {false, fmt::format("The exploration is {} and not paused.", toString(phase_))};
  }
  phase_ = paused_phase_;
  return {true, "The exploration goes on."};
}

Reply Explorer::setStrategy(const std::string& name) {
  try {
    strategy_ = makeStrategy(name);
  } catch (const std::invalid_argument&) {
    return {false, fmt::format("There is no strategy \"{}\"; known are {}.", name,
                               fmt::join(strategyNames(), ", "))};
  }
  config_.strategy = name;
  if (phase_ == Phase::kExploring) {
    dropGoal();  // the next decision gives another, which takes its place
  }
  return {true, fmt::format("The strategy is {}.", name)};
}

void Explorer::dropGoal() {
  goal_.reset();
  goal_state_ = GoalState::kNone;
  goal_ended_.reset();
  goal_moved_ = false;
}

void Explorer::account(double now, const std::optional<Pose2>& T_map_base) {
  const bool active = phase_ == Phase::kExploring || phase_ == Phase::kReturning;
  if (last_now_ && now < *last_now_) {  // the clock was set back
    last_decision_.reset();
    goal_ended_ = goal_ended_ ? std::optional<double>(now) : std::nullopt;
  }
  if (active && last_now_ && now > *last_now_) {
    progress_.time += now - *last_now_;
  }
  last_now_ = now;
  if (T_map_base) {
    if (active && last_pose_) {
      progress_.distance += geometry::distance(*last_pose_, *T_map_base);
    }
    last_pose_ = T_map_base;
  }
}

std::string Explorer::spentBudget() const {
  if (config_.time_budget > 0.0 && progress_.time >= config_.time_budget) {
    return fmt::format("The time of {:.0f} s is spent.", config_.time_budget);
  }
  if (config_.distance_budget > 0.0 && progress_.distance >= config_.distance_budget) {
    return fmt::format("The way of {:.0f} m is driven.", config_.distance_budget);
  }
  return "";
}

Order Explorer::endExploring(Ending ending, std::string reason) {
  dropGoal();
  ending_ = ending;
  reason_ = std::move(reason);
  failures_ = 0;
  phase_ = config_.return_home ? Phase::kReturning : Phase::kEnded;
  return cancel();
}

Order Explorer::cancel() {
  const bool is_driven = driven_.has_value();
  driven_.reset();
  return {is_driven ? Order::Kind::kCancel : Order::Kind::kKeepOn, {}};
}

Order Explorer::comeHome(double now, const Pose2& T_map_base) {
  constexpr double kAtHome = 0.3;  // [m]
  constexpr int kMaxAttempts = 3;  // to get there
  if (ending_ == Ending::kDone && map_is_new_ && isAnythingLeft(now, T_map_base)) {
    dropGoal();
    ending_ = Ending::kNone;
    reason_.clear();
    phase_ = Phase::kExploring;
    return {};
  }
  if (goal_state_ == GoalState::kDriving) {
    return {};
  }
  if (goal_state_ == GoalState::kFailed) {
    ++failures_;
  }
  const Pose2 place = placeAtHome(T_map_base);
  const bool is_reached = goal_state_ == GoalState::kReached && !isNearerHome(place, *goal_);
  const bool is_home = is_reached || geometry::distance(T_map_base, *home_) < kAtHome;
  dropGoal();
  if (failures_ >= kMaxAttempts) {
    return end(" The way home could not be driven.");
  }
  return is_home ? end(" The robot is home.") : goTo(place, 0);
}

Pose2 Explorer::placeAtHome(const Pose2& T_map_base) const {
  constexpr double kNearHome = 1.0;  // [m]
  const Survey survey = surveyFrom(T_map_base);
  const std::vector<Cell> cells = survey.room().nearestRoom(home_->translation(), kNearHome);
  const Cell home = MapView(*map_).cellAt(home_->translation());
  if (survey.room().hasRoomAt(home) || cells.empty()) {
    return *home_;
  }
  // A laser sees no floor below the robot, and may not have looked back at where it started.
  const Eigen::Vector2d place = MapView(*map_).center(cells.front());
  return {place.x(), place.y(), home_->theta};
}

bool Explorer::isNearerHome(const Pose2& place, const Goal& goal) const {
  constexpr double kNearer = 0.1;  // [m] by which the map now shows room nearer to home
  return geometry::distance(place, *home_) < geometry::distance(goal.T_map_base, *home_) - kNearer;
}

bool Explorer::isAnythingLeft(double now, const Pose2& T_map_base) {
  map_is_new_ = false;
  return !optionsNow(surveyFrom(T_map_base), now).empty();
}

Order Explorer::end(const std::string& addition) {
  reason_ += addition;
  phase_ = Phase::kEnded;
  return {};
}

}  // namespace omega_slam::exploration
