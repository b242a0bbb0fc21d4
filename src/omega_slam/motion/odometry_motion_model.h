#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::motion {

/// Noise of the odometry, as standard deviations of the three motions into which a step is split.
/// The squares of these numbers are alpha1..alpha4 of Probabilistic Robotics (Thrun, Burgard, Fox
/// 2005), tables 5.5 and 5.6: there, noise is given as variance per squared motion.
struct OdometryMotionModelConfig {
  double rotation_per_rotation{0.05};        ///< [rad/rad], sqrt(alpha1)
  double rotation_per_translation{0.03};     ///< [rad/m], sqrt(alpha2)
  double translation_per_translation{0.05};  ///< [m/m], sqrt(alpha3)
  double translation_per_rotation{0.01};     ///< [m/rad], sqrt(alpha4)

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// A step of the robot as rotation, straight translation, rotation (figure 5.7 of the textbook).
/// A step backwards is a negative translation, so that driving in reverse is not two half turns.
struct RotTransRot {
  double rot1{0.0};   ///< [rad]
  double trans{0.0};  ///< [m]
  double rot2{0.0};   ///< [rad]

  [[nodiscard]] static RotTransRot fromMotion(const geometry::Pose2& T_start_end);
  [[nodiscard]] geometry::Pose2 toMotion() const;  ///< `T_start_end`
};

/// The odometry motion model p(x_t | u_t, x_{t-1}).
class OdometryMotionModel {
 public:
  explicit OdometryMotionModel(
      const OdometryMotionModelConfig& config = {});  ///< @throws std::invalid_argument

  /// Draws a true motion for a measured one (table 5.6).
  /// @param measured `T_start_end` as the odometry has it; @return `T_start_end` as it may have
  /// been
  [[nodiscard]] geometry::Pose2 sample(const geometry::Pose2& measured,
                                       std::mt19937_64& random) const;

  /// Probability density of a motion given the measured one (table 5.5) [1/(rad m rad)].
  [[nodiscard]] double density(const geometry::Pose2& hypothesis,
                               const geometry::Pose2& measured) const;

  /// Covariance of (x, y, theta) of the measured motion in the frame of its start [m^2, m rad,
  /// rad^2], by the Jacobian of the motion with respect to (rot1, trans, rot2). Singular for a
  /// robot that stands still.
  [[nodiscard]] Eigen::Matrix3d covariance(const geometry::Pose2& measured) const;

 private:
  /// Standard deviations of (rot1, trans, rot2).
  [[nodiscard]] Eigen::Vector3d deviations(const RotTransRot& motion) const;

  OdometryMotionModelConfig config_;
};

}  // namespace omega_slam::motion
