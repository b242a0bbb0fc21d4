#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::sensing {

struct ScanIntakeConfig {
  double min_range{0.2};  ///< [m] Nearer returns are ignored; the scan's own range_min also holds.
  double max_range{
      0.0};  ///< [m] Farther returns say only "free so far"; 0: the scan's own range_max.
  double no_return_range{1.5};   ///< [m] A beam without return clears so far, but not beyond the
                                 ///< limit above; 0: nothing.
  bool nan_is_no_return{false};  ///< Some drivers (urg_node) say NaN where REP-117 asks for +inf.
  int min_beams{1};              ///< Scans with fewer beams are rejected.

  /// All violations, a sentence each; empty when valid.
  [[nodiscard]] std::vector<std::string> validate() const;
};

/// A scan made safe, or the reason why there is none. Facts for the caller to count and report.
struct ScanIntakeResult {
  std::optional<Sweep> sweep;
  geometry::Pose2 T_start_sweep;  ///< motion of the base from the scan's stamp to the sweep's
  std::string rejection;  ///< why there is no sweep, a short stable phrase; empty if there is
  std::vector<std::string> repairs;  ///< what had to be mended, short stable phrases
};

/// Guards the door: any scan goes in; a finite, ordered Sweep comes out, or a reason.
///
/// A beam is a return if range_min <= r <= range_max (this form also refuses NaN). +inf and finite
/// ranges above range_max mean that nothing was met; -inf and ranges below range_min mean "too
/// close" and say nothing (REP-117). Repaired: unset or senseless range limits, a senseless
/// time_increment, a clockwise sweep, a laser upside down. Rejected: no beams, too few, a stamp or
/// angles that are not finite, angle_increment 0, more than a full turn, not one beam that says
/// anything. The count of beams may differ from scan to scan.
///
/// @param motion_during_sweep `T_start_end`, the motion of the base from the first beam to the
///        last, by which beams are carried to the middle of the sweep (constant velocity); the
///        identity where none is known
class ScanIntake {
 public:
  explicit ScanIntake(
      const ScanIntakeConfig& config);  ///< @throws std::invalid_argument if not valid

  [[nodiscard]] ScanIntakeResult process(const LaserScan& scan, const LaserMount& mount,
                                         const geometry::Pose2& motion_during_sweep = {}) const;

 private:
  ScanIntakeConfig config_;
};

}  // namespace omega_slam::sensing
