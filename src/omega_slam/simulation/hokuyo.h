#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/simulation/surroundings.h"

namespace omega_slam::simulation {

/// Hokuyo URG-04LX-UG01, from its data sheet: 240 degrees, a mirror that turns ten times a second
/// and is sampled 1024 times a turn, accuracy +-30 mm up to 1 m and 3 % of the range beyond.
struct HokuyoConfig {
  double rate{10.0};  ///< [Hz] turns of the mirror, one scan each
  int beams{683};     ///< samples in the field of view, which is symmetric to straight ahead
  double angle_increment{2.0 * geometry::kPi / 1024.0};  ///< [rad] between beams
  double range_min{0.02};                                ///< [m] nearer is not measured
  double range_max{4.0};       ///< [m] farther is not measured (the device reaches 5.6 on white)
  double dark_range{1.5};      ///< [m] dark surfaces farther away swallow the beam
  double near_accuracy{0.03};  ///< [m] bound of the error up to `near_limit`
  double near_limit{1.0};      ///< [m]
  double far_accuracy{0.03};   ///< [m/m] bound of the error beyond, per range
  /// The data sheet calls its bounds accuracy and not deviation; we read them as this many standard
  /// deviations of a normal error that never leaves them.
  double accuracy_in_deviations{3.0};
  bool no_return_is_inf{false};  ///< true: +inf as REP-117 asks; false: NaN as urg_node sends

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// A laser that sweeps while it moves: beam i of a scan is cast at `stamp + i * time_increment`
/// from where the laser is at that time. A scan is finished when its last beam is.
class Hokuyo {
 public:
  /// @param start [s] time of the first beam of the first scan
  /// @throws std::invalid_argument if the configuration is not valid
  Hokuyo(const HokuyoConfig& config, double start, std::uint64_t seed);

  /// Casts the beams whose time is in [from.stamp, to.stamp); poses are `T_world_laser`, and the
  /// motion between them is taken as straight and steady. Calls follow each other without gaps and
  /// span less than one turn of the mirror.
  /// @return the scan whose last beam was among them
  [[nodiscard]] std::optional<sensing::LaserScan> sweep(const Surroundings& surroundings,
                                                        const geometry::StampedPose2& from,
                                                        const geometry::StampedPose2& to);

  [[nodiscard]] double scanPeriod() const { return 1.0 / config_.rate; }  ///< [s]

 private:
  void beginScan();
  [[nodiscard]] float measure(const Surroundings& surroundings,
                              const geometry::Pose2& T_world_laser, double angle);
  [[nodiscard]] double error(double range);

  HokuyoConfig config_;
  double start_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uint64_t scans_{0};  ///< begun so far
  sensing::LaserScan scan_;
};

}  // namespace omega_slam::simulation
