#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/matching/local_map.h"
#include "omega_slam/matching/map_matcher.h"
#include "omega_slam/matching/matcher_factory.h"

namespace omega_slam::slam {

/// A pose and how far it may be off.
struct Belief {
  geometry::Pose2 pose;
  /// Of (x, y, theta) [m^2, m rad, rad^2], in the axes of the frame that the pose is in.
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
};

/// What the odometry says of the motion from one scan to the next.
struct OdometryStep {
  geometry::Pose2 motion;                               ///< `T_before_after` of the base
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};  ///< in the axes of `before`
};

/// Where a scan was taken, by the odometry and by what it saw.
struct TrackedScan {
  Belief belief;                ///< `T_map_base`
  matching::MatchResult match;  ///< reference: the map
  bool is_trusted{false};       ///< whether the match had a say
  bool has_slipped{false};      ///< the match says that the odometry of this step was wrong
};

/// Follows the robot from scan to scan: predicts by the odometry, matches with a map, and fuses the
/// two by their covariances, as a Kalman filter does (Thrun, Burgard, Fox 2005, table 3.1).
///
/// The odometry is weighed, not believed: its variances are scaled by a factor that is learnt from
/// how far predictions and matches disagree, and a step that a sure match contradicts is taken for
/// a slip of the wheels and has no say at all.
class ScanTracker {
 public:
  ScanTracker(const matching::MatcherConfig& matching, double min_confidence);

  /// @param reference what the scan is matched with
  /// @param before where the scan before was taken, `T_map_base`
  [[nodiscard]] TrackedScan track(const matching::LocalMap& map, const matching::View& scan,
                                  const Belief& before, const OdometryStep& step);

  /// By which the odometry's variances are to be multiplied.
  [[nodiscard]] double odometryScale() const { return scale_; }

 private:
  [[nodiscard]] matching::MatchResult match(const matching::LocalMap& map,
                                            const matching::View& scan,
                                            const geometry::Pose2& guess) const;
  void learn(const Eigen::Vector3d& innovation, const Eigen::Matrix3d& covariance);

  double min_confidence_;
  std::unique_ptr<const matching::ScanMatcher> matcher_;
  const matching::MapMatcher* map_matcher_;  ///< matcher_, if it knows how to use a map
  double scale_{1.0};
};

}  // namespace omega_slam::slam
