// What a Navigator does in trouble: it bumps into something, or does not get on.
#include <cmath>

#include "omega_slam/grid/pane.h"
#include "omega_slam/navigation/navigator.h"
#include "omega_slam/sensing/contact.h"

namespace omega_slam::navigation {
namespace {

constexpr double kWaitCheck = 0.5;    // [s] between looks whether the way is free again
constexpr double kSameContact = 0.3;  // [s] bumpers that are pressed again so soon never let go
constexpr double kPressing = 2.0;     // [s] after which a robot that drives on presses anew

}  // namespace

void Navigator::touch(const std::vector<Eigen::Vector2d>& points, double now) {
  if (!last_pose_ || points.empty()) {
    return;
  }
  auto marks = sensing::contactMarks(points, *last_pose_, radius_);
  if (costmap_.hasMap()) {
    const auto panes = grid::paneMarks(costmap_.map(), points, *last_pose_, radius_);
    marks.insert(marks.end(), panes.begin(), panes.end());
  }
  costmap_.touch(marks, now);
  if (marks.empty()) {
    return;
  }
  // Where something behind it keeps the robot from backing off, it must turn and drive off while
  // the bumpers are still pressed: it would give up at once if that were one contact after another.
  const auto isLongAgo = [now](const std::optional<double>& then, double duration) {
    return !then || std::abs(now - *then) > duration;
  };
  if (isLongAgo(touched_at_, kSameContact) || (!recovering_ && isLongAgo(contact_at_, kPressing))) {
    in_contact_ = true;
    contact_at_ = now;
  }
  touched_at_ = now;
}

NavigatorStep Navigator::trouble(const std::string& reason, const geometry::Pose2& T_map_base) {
  reason_ = reason;
  recovery_.next(now_, T_map_base);
  recovering_ = true;
  turned_ = 0.0;
  blocked_ = false;
  return recover(T_map_base, 0.0);
}

NavigatorStep Navigator::recover(const geometry::Pose2& T_map_base, double dt) {
  NavigatorStep result;
  result.state = NavigationState::kRecovering;
  result.reason = reason_;
  result.recovery = recovery_.stage();
  turned_ += std::abs(velocity_.angular) * dt;
  bool over = recovery_.isOver(now_, T_map_base, turned_);
  switch (recovery_.stage()) {
    case RecoveryStage::kGiveUp:
      return finish(NavigationState::kFailed, reason_);
    case RecoveryStage::kClear:
      costmap_.forgetSeen();
      break;
    case RecoveryStage::kBackOff:
      over = over || !follower_.isClearStraight(costmap_, T_map_base, -0.1);
      result.velocity.linear = over ? 0.0 : -config_.recovery.back_off_speed;
      break;
    case RecoveryStage::kTurn:
      result.velocity = {0.0, over ? 0.0 : config_.recovery.turn_speed};
      break;
    case RecoveryStage::kWait:
      // People pass, and then there is no need to wait any longer.
      if (now_ - planned_at_ >= kWaitCheck) {
        over = replan(T_map_base) || over;
      }
      break;
    case RecoveryStage::kNone:
      break;
  }
  if (over) {
    recovering_ = false;
    moved_at_ = nearer_at_ = now_;
    follower_.stop();  // from here on it needs a new plan
  }
  return result;
}

}  // namespace omega_slam::navigation
