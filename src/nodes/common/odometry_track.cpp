#include "nodes/common/odometry_track.h"

#include <algorithm>

namespace omega_slam {

motion::OdometryVerdict OdometryTrack::add(const motion::Prediction& prediction) {
  const auto verdict = poses_.add(prediction.stamp, prediction.T_odom_base);
  if (verdict == motion::OdometryVerdict::kTimeJumpedBack) {
    covariances_.clear();
  }
  if (verdict == motion::OdometryVerdict::kTimeJumpedBack ||
      verdict == motion::OdometryVerdict::kAccepted) {
    covariances_.emplace_back(prediction.stamp, prediction.covariance);
  }
  while (!covariances_.empty() && covariances_.front().first < poses_.oldest()) {
    covariances_.pop_front();
  }
  return verdict;
}

bool OdometryTrack::covers(double from, double to) const {
  return poses_.covers(from) && poses_.covers(to);
}

bool OdometryTrack::isTooOld(double stamp) const {
  return !poses_.empty() && stamp < poses_.oldest();
}

std::optional<double> OdometryTrack::newest() const {
  return poses_.empty() ? std::nullopt : std::optional(poses_.newest());
}

std::optional<motion::Prediction> OdometryTrack::at(double stamp) const {
  const auto pose = poses_.at(stamp);
  const auto covariance =
      std::lower_bound(covariances_.begin(), covariances_.end(), stamp,
                       [](const auto& entry, double moment) { return entry.first < moment; });
  if (!pose || covariance == covariances_.end()) {
    return std::nullopt;
  }
  return motion::Prediction{stamp, *pose, covariance->second};
}

geometry::Pose2 OdometryTrack::motionDuring(double start, double duration) const {
  const auto first = poses_.at(start);
  const auto last = poses_.at(start + duration);
  return first && last ? geometry::relativePose(*first, *last) : geometry::Pose2{};
}

}  // namespace omega_slam
