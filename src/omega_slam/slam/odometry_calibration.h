#pragma once

#include <Eigen/Core>
#include <string>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/slam/belief.h"

namespace omega_slam::slam {

/// What is always wrong with an odometry: by how much true motions are more than it has them.
struct OdometryFaults {
  double way{0.0};    ///< as a share of the way
  double aside{0.0};  ///< [rad] that ways lead to the left of the heading
  double turn{0.0};   ///< as a share of the turn
  double bend{0.0};   ///< [rad/m] of turn, with the way forward
};

/// In a sentence for people; what is too little to matter is left out.
[[nodiscard]] std::string describe(const OdometryFaults& faults);

/// Learns what is always wrong with the odometry from where scans say that the robot has come:
/// wheels of another radius or distance than is believed, wheels that differ, and a laser that
/// looks askew, which is no fault of the odometry but shows as ways that lead aside.
///
/// Robots have calibrated themselves so for long (Roy and Thrun, *Online self-calibration for
/// mobile robots*, ICRA 1999). Here it is a Kalman filter (Thrun, Burgard, Fox 2005, table 3.1)
/// for four faults, in which the difference of two motions is linear. What a match does not know
/// teaches nothing; what was learnt is forgotten slowly. A fault is believed as far as it stands
/// out from chance: a robot without faults goes on as if nothing were learnt.
class OdometryCalibration {
 public:
  using Effects = Eigen::Matrix<double, 3, 4>;  ///< of each fault on a motion (x, y, theta)

  OdometryCalibration();

  /// @param by_odometry a motion as the odometry has it, and how far that may be off, such faults
  /// aside; in the axes of its start
  /// @param by_match the same by what was seen
  void note(const Belief& by_odometry, const Belief& by_match);

  /// As far as they are believed.
  [[nodiscard]] OdometryFaults faults() const;

  /// Whether a motion is so short that it can be corrected. What faults do to a long one depends on
  /// the way in between.
  [[nodiscard]] static bool isFor(const geometry::Pose2& motion);

  /// A motion by the odometry without them; a long one as it is.
  [[nodiscard]] geometry::Pose2 corrected(const geometry::Pose2& by_odometry) const;

 private:
  void forget(const Effects& effects);
  [[nodiscard]] Eigen::Vector4d believed() const;

  Eigen::Vector4d mean_{Eigen::Vector4d::Zero()};  ///< in the order of OdometryFaults
  Eigen::Matrix4d covariance_;
};

}  // namespace omega_slam::slam
