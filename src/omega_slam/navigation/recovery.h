#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::navigation {

struct RecoveryConfig {
  double wait{3.0};               ///< [s] that it waits for what stands in the way to go on
  double back_off_distance{0.3};  ///< [m]
  double back_off_speed{0.12};    ///< [m/s]
  double turn_speed{1.0};         ///< [rad/s] of the full turn by which it looks around
  int rounds{2};                  ///< times that all stages are gone through before it gives up

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// In this order.
enum class RecoveryStage {
  kNone,     ///< all is well
  kWait,     ///< people go on
  kClear,    ///< obstacles that nobody sees any more are forgotten
  kBackOff,  ///< away from what is touched
  kTurn,     ///< the laser sees what was behind it
  kGiveUp
};

[[nodiscard]] std::string nameOf(RecoveryStage stage);

/// Which stage of getting out of trouble comes next, and how long each lasts. It moves nothing
/// itself, and has no clock.
class Recovery {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  explicit Recovery(const RecoveryConfig& config);

  /// All is well: the next trouble begins with the first stage.
  void reset();

  /// There is trouble: goes on to the next stage. After the last of the last round it is kGiveUp.
  void next(double now, const geometry::Pose2& T_map_base);

  /// There is contact: backs off at once, whatever was before. Gives up after so many rounds, too.
  void backOff(double now, const geometry::Pose2& T_map_base);

  /// Whether the stage has lasted long enough. @param turned [rad] since it began, either way
  [[nodiscard]] bool isOver(double now, const geometry::Pose2& T_map_base, double turned) const;

  [[nodiscard]] RecoveryStage stage() const { return stage_; }
  [[nodiscard]] const RecoveryConfig& config() const { return config_; }

 private:
  void enter(RecoveryStage stage, double now, const geometry::Pose2& T_map_base);

  RecoveryConfig config_;
  RecoveryStage stage_{RecoveryStage::kNone};
  int round_{0};
  double since_{0.0};
  geometry::Pose2 from_;
};

}  // namespace omega_slam::navigation
