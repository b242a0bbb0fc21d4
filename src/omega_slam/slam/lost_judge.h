#pragma once

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/slam/scan_tracker.h"

namespace omega_slam::slam {

/// Says when a robot is lost: when the map has contradicted all that it saw over some distance, or
/// some time. A person in the way does not do it, and neither does a room that is new: about that
/// the map knows nothing.
class LostJudge {
 public:
  /// @param lost_distance [m] of driving, > 0
  explicit LostJudge(double lost_distance) : lost_distance_(lost_distance) {}

  /// @param motion of the base since the scan before
  /// @param seconds since then
  void note(const TrackedScan& scan, const geometry::Pose2& motion, double seconds);

  /// The robot has been found.
  void rest();

  [[nodiscard]] bool isLost() const { return is_lost_; }

 private:
  double lost_distance_;
  double way_{0.0};   ///< [m] since a scan was last believed, while they were contradicted
  double time_{0.0};  ///< [s] likewise
  bool is_lost_{false};
};

}  // namespace omega_slam::slam
