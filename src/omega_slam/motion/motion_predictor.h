#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/odometry_motion_model.h"

namespace omega_slam::motion {

/// Where the robot believes it is by its wheels alone, and how far that belief has spread since the
/// anchor.
struct Prediction {
  double stamp{0.0};            ///< [s]
  geometry::Pose2 T_odom_base;  ///< as the odometry says
  /// Of the motion since the anchor (the last keyframe), in the axes of the odometry frame [m^2, m
  /// rad, rad^2].
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
};

/// Carries the odometry motion model along the path driven since an anchor, the last keyframe.
///
/// The textbook gives the noise of one step from the size of the step. Odometry comes at 50 Hz, and
/// independent noise in proportion to such tiny steps would average itself away; so the path is cut
/// into segments of a set size, and each segment is one step of the model.
class MotionPredictor {
 public:
  /// @param samples how many poses samples() draws
  explicit MotionPredictor(const OdometryMotionModelConfig& noise = {}, int samples = 0,
                           std::uint64_t seed = 1);

  /// Forgets the spread: from here on, covariance and samples are of the motion since this pose.
  void anchor(const geometry::Pose2& T_odom_base);

  /// Follows the odometry to its next pose; the first call anchors.
  [[nodiscard]] Prediction predict(double stamp, const geometry::Pose2& T_odom_base);

  /// Poses drawn from the belief at the last prediction, in the odometry frame.
  [[nodiscard]] std::vector<geometry::Pose2> samples();

  void reset();  ///< the next prediction anchors anew

 private:
  void closeSegment(const geometry::Pose2& T_odom_base);
  [[nodiscard]] Eigen::Matrix3d covarianceAt(const geometry::Pose2& T_odom_base) const;
  [[nodiscard]] std::vector<geometry::Pose2> samplesAt(const geometry::Pose2& T_odom_base);

  OdometryMotionModel model_;
  std::mt19937_64 random_;
  std::size_t sample_count_;
  bool anchored_{false};
  geometry::Pose2 T_odom_segment_;  ///< start of the open segment
  geometry::Pose2 T_odom_base_;     ///< newest odometry
  Eigen::Matrix3d segment_covariance_{
      Eigen::Matrix3d::Zero()};                   ///< at the start of the open segment
  std::vector<geometry::Pose2> segment_samples_;  ///< at the start of the open segment
};

}  // namespace omega_slam::motion
