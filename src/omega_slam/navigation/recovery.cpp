#include "omega_slam/navigation/recovery.h"

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::navigation {
namespace {

constexpr double kPatience = 2.0;  // times what a motion should take, after which it is over

}  // namespace

std::vector<std::string> RecoveryConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("wait", wait, 0.0);
  violations.requireAtLeast("back_off_distance", back_off_distance, 0.0);
  violations.requireAbove("back_off_speed", back_off_speed, 0.0);
  violations.requireAbove("turn_speed", turn_speed, 0.0);
  violations.requireAtLeast("rounds", rounds, 0.0);
  return violations.sentences();
}

std::string nameOf(RecoveryStage stage) {
  switch (stage) {
    case RecoveryStage::kWait:
      return "wait";
    case RecoveryStage::kClear:
      return "clear";
    case RecoveryStage::kBackOff:
      return "back off";
    case RecoveryStage::kTurn:
      return "turn";
    case RecoveryStage::kGiveUp:
      return "give up";
    case RecoveryStage::kNone:
      break;
  }
  return "none";
}

Recovery::Recovery(const RecoveryConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
}

void Recovery::reset() {
  stage_ = RecoveryStage::kNone;
  round_ = 0;
}

void Recovery::enter(RecoveryStage stage, double now, const geometry::Pose2& T_map_base) {
  stage_ = stage;
  since_ = now;
  from_ = T_map_base;
}

void Recovery::next(double now, const geometry::Pose2& T_map_base) {
  switch (stage_) {
    case RecoveryStage::kNone:
      enter(config_.rounds > 0 ? RecoveryStage::kWait : RecoveryStage::kGiveUp, now, T_map_base);
      return;
    case RecoveryStage::kWait:
      enter(RecoveryStage::kClear, now, T_map_base);
      return;
    case RecoveryStage::kClear:
      enter(RecoveryStage::kBackOff, now, T_map_base);
      return;
    case RecoveryStage::kBackOff:
      enter(RecoveryStage::kTurn, now, T_map_base);
      return;
    case RecoveryStage::kTurn:
      ++round_;
      enter(round_ < config_.rounds ? RecoveryStage::kWait : RecoveryStage::kGiveUp, now,
            T_map_base);
      return;
    case RecoveryStage::kGiveUp:
      return;
  }
}

void Recovery::backOff(double now, const geometry::Pose2& T_map_base) {
  if (stage_ == RecoveryStage::kBackOff || stage_ == RecoveryStage::kTurn) {
    ++round_;  // it has just tried that
  }
  enter(round_ < config_.rounds ? RecoveryStage::kBackOff : RecoveryStage::kGiveUp, now,
        T_map_base);
}

bool Recovery::isOver(double now, const geometry::Pose2& T_map_base, double turned) const {
  const double lasted = now - since_;
  switch (stage_) {
    case RecoveryStage::kWait:
      return lasted >= config_.wait;
    case RecoveryStage::kBackOff:
      return geometry::distance(from_, T_map_base) >= config_.back_off_distance ||
             lasted >= kPatience * config_.back_off_distance / config_.back_off_speed;
    case RecoveryStage::kTurn:
      return turned >= 2.0 * geometry::kPi ||
             lasted >= kPatience * 2.0 * geometry::kPi / config_.turn_speed;
    default:
      return true;
  }
}

}  // namespace omega_slam::navigation
