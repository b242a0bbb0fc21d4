#include "omega_slam/evaluation/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;
using geometry::StampedPose2;
using geometry::Trajectory;

/// Poses that can be asked by time.
class Timeline {
 public:
  /// Of poses with equal stamps, which real logs do hold, the first counts. Sorting them too makes
  /// the result independent of the order of the file, and is what the benchmark's tool does.
  explicit Timeline(Trajectory poses) : poses_(std::move(poses)) {
    std::sort(poses_.begin(), poses_.end(), [](const StampedPose2& a, const StampedPose2& b) {
      return std::tie(a.stamp, a.pose.x, a.pose.y, a.pose.theta) <
             std::tie(b.stamp, b.pose.x, b.pose.y, b.pose.theta);
    });
  }

  [[nodiscard]] bool isEmpty() const { return poses_.empty(); }

  /// First pose at or after the stamp; may be the end.
  [[nodiscard]] std::size_t after(double stamp) const {
    const auto found =
        std::lower_bound(poses_.begin(), poses_.end(), stamp,
                         [](const StampedPose2& pose, double value) { return pose.stamp < value; });
    return static_cast<std::size_t>(found - poses_.begin());
  }

  /// The pose nearest in time; of two equally near the earlier. There must be one.
  [[nodiscard]] const StampedPose2& nearest(double stamp) const {
    const std::size_t next = after(stamp);
    if (next == 0) {
      return poses_.front();
    }
    if (next == poses_.size()) {
      return poses_.back();
    }
    const StampedPose2& before = poses_[next - 1];
    return std::abs(poses_[next].stamp - stamp) < std::abs(before.stamp - stamp) ? poses_[next]
                                                                                 : before;
  }

  /// Between the two neighbours, or nothing where there is no pose on both sides or both are too
  /// far away.
  [[nodiscard]] std::optional<Pose2> between(double stamp, double max_gap) const {
    const std::size_t next = after(stamp);
    if (next == 0 || next == poses_.size()) {
      return std::nullopt;
    }
    const StampedPose2& before = poses_[next - 1];
    const StampedPose2& behind = poses_[next];
    if (std::min(stamp - before.stamp, behind.stamp - stamp) > max_gap) {
      return std::nullopt;
    }
    const double share = (stamp - before.stamp) / (behind.stamp - before.stamp);
    return geometry::interpolate(before.pose, behind.pose, share);
  }

  /// The nearest pose if within the tolerance, else between the neighbours.
  [[nodiscard]] std::optional<Pose2> at(double stamp, double tolerance, double max_gap) const {
    if (isEmpty()) {
      return std::nullopt;
    }
    const StampedPose2& close = nearest(stamp);
    return std::abs(close.stamp - stamp) <= tolerance ? std::optional<Pose2>(close.pose)
                                                      : between(stamp, max_gap);
  }

 private:
  Trajectory poses_;
};

std::optional<Pose2> poseAt(const Timeline& trajectory, const Timeline& odometry, double stamp,
                            const RelationsOptions& options) {
  std::optional<Pose2> pose = trajectory.at(stamp, options.tolerance, options.max_gap);
  if (!pose || odometry.isEmpty()) {
    return pose;
  }
  const StampedPose2& known = trajectory.nearest(stamp);
  if (std::abs(known.stamp - stamp) <= options.tolerance) {
    return pose;
  }
  const std::optional<Pose2> T_odom_known = odometry.at(known.stamp, 0.0, options.max_gap);
  const std::optional<Pose2> T_odom_wanted = odometry.at(stamp, 0.0, options.max_gap);
  if (T_odom_known && T_odom_wanted) {
    return known.pose * geometry::relativePose(*T_odom_known, *T_odom_wanted);
  }
  return pose;
}

}  // namespace

std::vector<std::string> RelationsOptions::validate() const {
  std::vector<std::string> faults;
  if (!std::isfinite(tolerance) || tolerance < 0.0) {
    faults.push_back(fmt::format("tolerance must be 0 s or above, but it is {}.", tolerance));
  }
  if (!std::isfinite(max_gap) || max_gap < 0.0) {
    faults.push_back(fmt::format("max_gap must be 0 s or above, but it is {}.", max_gap));
  }
  return faults;
}

RelationsScore scoreRelations(const Trajectory& trajectory,
                              const std::vector<graph::Relation>& relations,
                              const Trajectory& odometry, const RelationsOptions& options) {
  if (const std::vector<std::string> faults = options.validate(); !faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  const Timeline estimate(trajectory);
  const Timeline wheels(odometry);
  std::vector<double> translations;
  std::vector<double> rotations;
  for (const graph::Relation& relation : relations) {
    const auto from = poseAt(estimate, wheels, relation.from_stamp, options);
    const auto to = poseAt(estimate, wheels, relation.to_stamp, options);
    if (from && to) {
      const Pose2 error =
          geometry::relativePose(relation.T_from_to, geometry::relativePose(*from, *to));
      translations.push_back(error.translation().norm());
      rotations.push_back(std::abs(error.theta));
    }
  }
  return {relations.size(), translations.size(), summarize(translations), summarize(rotations)};
}

}  // namespace omega_slam::evaluation
