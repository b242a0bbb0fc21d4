#include "omega_slam/sensing/scan_intake.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"
#include "omega_slam/sensing/sweep_duration.h"

namespace omega_slam::sensing {

using geometry::Pose2;

namespace {

/// No 2D laser sees farther [m]; where a scan states no limit, this one holds.
constexpr double kFarthest = 1000.0;

struct Limits {
  double min{0.0};        // [m] nearer: too close
  double max{kFarthest};  // [m] farther: free so far
  double clear{0.0};      // [m] length that a beam without return clears
};

/// Why a scan can't be used at all; empty if it can.
std::string rejectionOf(const LaserScan& scan, int min_beams) {
  if (scan.ranges.empty()) {
    return "no beams";
  }
  if (scan.ranges.size() < static_cast<std::size_t>(min_beams)) {
    return "too few beams";
  }
  if (!std::isfinite(scan.stamp)) {
    return "stamp is not finite";
  }
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment)) {
    return "angles are not finite";
  }
  const double step = std::abs(scan.angle_increment);
  if (step == 0.0 && scan.ranges.size() > 1) {
    return "angle_increment is zero";
  }
  // One beam of overlap is common: 0 and 360 degrees are both measured.
  if (step * static_cast<double>(scan.ranges.size() - 1) > 2.0 * geometry::kPi + step) {
    return "more than a full turn";
  }
  return {};
}

Limits limitsOf(const LaserScan& scan, const ScanIntakeConfig& config,
                std::vector<std::string>& repairs) {
  Limits limits;
  if (scan.range_min >= 0.0 && std::isfinite(scan.range_min)) {
    limits.min = scan.range_min;
  } else {
    repairs.emplace_back("range_min is senseless");
  }
  if (scan.range_max > limits.min && std::isfinite(scan.range_max)) {
    limits.max = scan.range_max;
  } else {
    repairs.emplace_back("range_max is senseless");
    limits.min = 0.0;
  }
  limits.min = std::max(limits.min, config.min_range);
  if (config.max_range > 0.0) {
    limits.max = std::min(limits.max, config.max_range);
  }
  limits.clear = std::min(config.no_return_range, limits.max);
  return limits;
}

bool takesTime(const LaserScan& scan, std::vector<std::string>& repairs) {
  const bool takes_time = sweepDuration(scan) > 0.0;
  if (!takes_time && scan.ranges.size() > 1 && scan.time_increment != 0.0) {
    repairs.emplace_back("time_increment is senseless");
  }
  return takes_time;
}

/// Where the base was while a sweep was taken, seen from the middle of it.
class SweepMotion {
 public:
  /// @param T_start_end the whole motion
  SweepMotion(const Pose2& T_start_end, std::size_t beams)
      : T_start_middle_(interpolate(Pose2{}, T_start_end, 0.5)),
        T_middle_first_(T_start_middle_.inverse()),
        T_middle_last_(T_middle_first_ * T_start_end),
        last_(std::max(1.0, static_cast<double>(beams) - 1.0)) {}

  [[nodiscard]] const Pose2& fromStart() const { return T_start_middle_; }
  [[nodiscard]] Pose2 at(std::size_t beam) const {
    return interpolate(T_middle_first_, T_middle_last_, static_cast<double>(beam) / last_);
  }

 private:
  Pose2 T_start_middle_;
  Pose2 T_middle_first_;
  Pose2 T_middle_last_;
  double last_;
};

Eigen::Vector2d directionAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// @param turn, direction of unit length
Eigen::Vector2d turnedBy(const Eigen::Vector2d& turn, const Eigen::Vector2d& direction) {
  return {turn.x() * direction.x() - turn.y() * direction.y(),
          turn.y() * direction.x() + turn.x() * direction.y()};
}

struct Reading {
  BeamKind kind{BeamKind::kUnknown};
  double range{0.0};  // [m]
};

Reading readBeam(double range, const Limits& limits, bool nan_is_no_return) {
  if (range >= limits.min && range <= limits.max) {
    return {BeamKind::kReturn, range};
  }
  const bool nothing_met = range > limits.max || (std::isnan(range) && nan_is_no_return);
  if (nothing_met && limits.clear > 0.0) {
    return {BeamKind::kNoReturn, limits.clear};
  }
  return {};
}

}  // namespace

std::vector<std::string> ScanIntakeConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("min_range", min_range, 0.0);
  violations.requireAtLeast("max_range", max_range, 0.0);
  violations.requireAtLeast("no_return_range", no_return_range, 0.0);
  violations.requireAtLeast("min_beams", min_beams, 1);
  if (max_range > 0.0) {
    violations.requireAbove("max_range", max_range, min_range);
  }
  return violations.sentences();
}

ScanIntake::ScanIntake(const ScanIntakeConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
}

ScanIntakeResult ScanIntake::process(const LaserScan& scan, const LaserMount& mount,
                                     const Pose2& motion_during_sweep) const {
  ScanIntakeResult result;
  result.rejection = rejectionOf(scan, config_.min_beams);
  if (!result.rejection.empty()) {
    return result;
  }
  const Limits limits = limitsOf(scan, config_, result.repairs);
  const bool moves = takesTime(scan, result.repairs);
  const double turn = mount.upside_down ? -1.0 : 1.0;
  const SweepMotion motion(moves ? motion_during_sweep : Pose2{}, scan.ranges.size());
  result.T_start_sweep = motion.fromStart();

  const geometry::PointTransform T_base_laser(mount.T_base_laser);
  Sweep sweep{middleOfSweep(scan), mount.T_base_laser, std::abs(scan.angle_increment), {}};
  sweep.beams.reserve(scan.ranges.size());
  bool says_anything = false;
  // Turned from beam to beam: a sine of each takes as long as all else here, and after a thousand
  // beams the difference is 1e-13.
  Eigen::Vector2d direction = directionAt(turn * scan.angle_min);
  const Eigen::Vector2d step = directionAt(turn * scan.angle_increment);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const Reading reading = readBeam(scan.ranges[i], limits, config_.nan_is_no_return);
    Beam beam;
    beam.kind = reading.kind;
    if (beam.kind != BeamKind::kUnknown) {
      const Eigen::Vector2d p_base = T_base_laser * (reading.range * direction);
      beam.end = moves ? motion.at(i) * p_base : p_base;
      says_anything = true;
    }
    sweep.beams.push_back(beam);
    direction = turnedBy(step, direction);
  }
  if (!says_anything) {
    result.rejection = "no beam says anything";
    return result;
  }
  if (turn * scan.angle_increment < 0.0) {
    result.repairs.emplace_back("sweeps clockwise");
    std::reverse(sweep.beams.begin(), sweep.beams.end());
  }
  result.sweep = std::move(sweep);
  return result;
}

}  // namespace omega_slam::sensing
