#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::sensing {

/// Notices a laser, or a driver, that hangs and sends one scan again and again. Ranges have noise:
/// a laser that works hardly ever sees the very same twice, and never does while it moves.
class FrozenLaser {
 public:
  static constexpr const char* kRejection = "scan repeats the one before";

  /// @param ranges      [m] as they came
  /// @param T_odom_base where the odometry says that they were seen from
  /// @return whether they are the same as before though the robot has moved since they were new
  [[nodiscard]] bool repeats(const std::vector<float>& ranges, const geometry::Pose2& T_odom_base);

 private:
  std::vector<float> ranges_;
  geometry::Pose2 T_odom_base_;  ///< when they were new
};

}  // namespace omega_slam::sensing
