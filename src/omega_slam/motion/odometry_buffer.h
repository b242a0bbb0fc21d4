#pragma once

#include <deque>
#include <optional>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::motion {

/// What became of an odometry pose that was offered to the buffer.
enum class OdometryVerdict { kAccepted, kNotFinite, kDuplicate, kOutOfOrder, kTimeJumpedBack };

/// The recent odometry, ordered by time, to be asked for the pose at any moment that it covers.
class OdometryBuffer {
 public:
  /// @param horizon [s] older poses are forgotten
  /// @param jump    [s] a stamp older than the newest by more than this is a jump of the clock, not
  /// a late message
  explicit OdometryBuffer(double horizon = 30.0, double jump = 1.0);

  /// On kTimeJumpedBack the buffer has been emptied and holds only the new pose.
  OdometryVerdict add(double stamp, const geometry::Pose2& T_odom_base);

  /// `T_odom_base` at the stamp, interpolated; none if the stamp lies outside of what is held.
  [[nodiscard]] std::optional<geometry::Pose2> at(double stamp) const;

  [[nodiscard]] bool covers(double stamp) const;
  [[nodiscard]] bool empty() const { return poses_.empty(); }
  [[nodiscard]] double oldest() const {
    return poses_.front().stamp;
  }  ///< [s]; not on an empty buffer
  [[nodiscard]] double newest() const {
    return poses_.back().stamp;
  }  ///< [s]; not on an empty buffer
  /// What is held, oldest first.
  [[nodiscard]] const std::deque<geometry::StampedPose2>& poses() const { return poses_; }
  void clear() { poses_.clear(); }

 private:
  double horizon_;
  double jump_;
  std::deque<geometry::StampedPose2> poses_;
};

}  // namespace omega_slam::motion
