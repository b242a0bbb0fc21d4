#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "slam/recording.h"
#include "slam/slam_run.h"

namespace omega_slam::experiments {

/// Beyond which a loop is violated: so Hess et al. count ("Real-time loop closure in 2D LIDAR
/// SLAM", ICRA 2016, table IV).
inline constexpr double kLoopTranslation = 0.20;                // [m]
inline constexpr double kLoopRotation = 0.0174532925199432957;  // [rad], 1 degree

/// How good a run was. What can't be said of a recording is NaN.
///
/// The error of a log is that of its ground-truth relations: mean and standard deviation of those
/// covered. The error of a simulated drive is that of the absolute trajectory: root mean square,
/// and standard deviation.
struct SlamScore {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  std::size_t scans{0};
  std::size_t rejected{0};  ///< of them
  std::size_t keyframes{0};
  double error{kUnknown};  ///< [m]
  double error_deviation{kUnknown};
  double worst{kUnknown};  ///< [m] error of any relation, or pose
  double turn{kUnknown};   ///< [rad] error
  double turn_deviation{kUnknown};
  double covered{kUnknown};         ///< [0, 1] of the relations, or scans
  double odometry_error{kUnknown};  ///< [m] the error of the odometry alone
  std::size_t loops{0};             ///< found, withdrawn ones included
  std::size_t violated{0};          ///< of them, by the final solution
  std::size_t withdrawn{0};         ///< of them
  /// Of those that stand, how many are false: they miss the truth by more than 20 cm or 1 degree,
  /// and by more than they allow. Counted in simulation only.
  double false_loops{kUnknown};
};

[[nodiscard]] SlamScore scoreRun(const Recording& recording, const SlamRun& run);

/// How true the graph's covariances are: poses of keyframes seen from the first one against the
/// truth.
struct Honesty {
  double squared_length{SlamScore::kUnknown};   ///< mean squared Mahalanobis length / 3; 1 is true
  double worst_along{SlamScore::kUnknown};      ///< [m] error in x, the world's, at its worst
  double deviation_there{SlamScore::kUnknown};  ///< [m] what the graph says of it
  double within{SlamScore::kUnknown};  ///< share of keyframes with x within three deviations
};

/// @param recording a simulated one whose drive begins along the x axis
[[nodiscard]] Honesty judgeCovariances(const Recording& recording, const SlamRun& run);

/// The table of scores: columns, and one row. Angles in degrees.
[[nodiscard]] std::string scoreColumns();
[[nodiscard]] std::string scoreCells(const SlamScore& score);

[[nodiscard]] std::string honestyColumns();
[[nodiscard]] std::string honestyCells(const Honesty& honesty);

/// What it took: processor seconds in all, milliseconds a scan.
[[nodiscard]] std::string costColumns();
[[nodiscard]] std::string costCells(const SlamRun& run);

}  // namespace omega_slam::experiments
