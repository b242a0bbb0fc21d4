#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/sensing/sweep.h"

namespace omega_slam::sensing {

struct ScanIntakeConfig {
  double min_range{
      0.0};  ///< [m] Returns nearer than this are ignored; the scan's own range_min also holds.
  double max_range{
      0.0};  ///< [m] Returns farther than this say only "free so far"; 0: the scan's own range_max.
  double no_return_range{
      0.0};  ///< [m] Length that a beam with no return (+inf) clears; 0: the limit above.
  bool nan_is_no_return{false};  ///< Some drivers (urg_node) say NaN where REP-117 asks for +inf.
  int min_beams{1};              ///< Scans with fewer beams are rejected.

  /// All violations, a sentence each; empty when valid.
  [[nodiscard]] std::vector<std::string> validate() const;
};

/// A scan made safe, or the reason why there is none. Facts for the caller to count and report.
struct ScanIntakeResult {
  std::optional<Sweep> sweep;
  std::string rejection;  ///< why there is no sweep, a short stable phrase; empty if there is
  std::vector<std::string> repairs;  ///< what had to be mended, short stable phrases
};

/// Guards the door: any scan goes in, a finite and ordered Sweep comes out, or a reason.
///
/// Repairs: infinite or unset range limits, range_min < 0, swapped or empty range limits, negative
/// time_increment, clockwise sweep, laser upside down. Rejects: no beams, NaN or zero
/// angle_increment, NaN stamp, more than one full turn by more than a beam, no usable beam. The
/// count of beams may differ from scan to scan.
///
/// @param motion_during_sweep `T_start_end`, the motion of the base from the first beam to the
/// last, by which
///        beams are carried back to the stamp (constant velocity); the identity where none is known
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
