#pragma once

#include "omega_slam/slam/belief.h"

namespace omega_slam::slam {

/// By which factor the odometry's variances are to be multiplied, learnt from where scans say that
/// the robot has come.
///
/// The difference of the two is normally distributed with the covariance s Q + R, where Q is what
/// the odometry states, R what the match states, and s the factor. Its logarithm climbs the
/// likelihood by Fisher scoring (Kay, *Fundamentals of Statistical Signal Processing: Estimation
/// Theory*, 1993, section 7.7, with its information matrix of section 3.9), where what was learnt
/// is forgotten by and by. What a match does not know, such as a way along a bare corridor, has
/// next to no part in it.
///
/// Asked are the way and the turn. What a robot on two wheels errs sideways follows from its turn;
/// the odometry motion model, which puts all of a turn at the ends of a way, states three times the
/// variance of wheels that drift all along.
class OdometryScale {
 public:
  /// @param by_odometry the pose at the end of a way by the odometry, and how far it may be off,
  /// not scaled; both beliefs in one frame
  /// @param by_match the pose there by what was seen
  void note(const Belief& by_odometry, const Belief& by_match);

  [[nodiscard]] double value() const { return scale_; }

 private:
  double scale_{1.0};
  double information_{2.0};  ///< of its logarithm; at first: one, within a factor of two
};

}  // namespace omega_slam::slam
