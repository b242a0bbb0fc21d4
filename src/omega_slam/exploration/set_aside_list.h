#pragma once

#include <Eigen/Core>
#include <vector>

#include "omega_slam/geometry/map_motion.h"

namespace omega_slam::exploration {

/// A frontier that is left alone for a while, known by its place: ids do not outlast what a
/// frontier goes through while nobody cares for it.
struct SetAside {
  Eigen::Vector2d place{0.0, 0.0};     ///< [m] map frame
  std::vector<Eigen::Vector2d> tried;  ///< [m] viewpoints that were tried for it
  double until{0.0};                   ///< [s] from then on it is tried again
  int failures{0};                     ///< times that a viewpoint was not reached
};

/// The frontiers that were tried in vain. Not thread-safe.
class SetAsideList {
 public:
  /// Whether a frontier at a place [m] is to be left alone: for now, or because it was tried as
  /// often as makes sense.
  [[nodiscard]] bool isLeftAlone(const Eigen::Vector2d& place, double now, int max_attempts) const;

  /// [m] The viewpoints that were tried for a frontier at a place [m].
  [[nodiscard]] std::vector<Eigen::Vector2d> triedFor(const Eigen::Vector2d& place) const;

  /// @param place [m] of the frontier; @param viewpoint [m] that was tried
  /// @param reached whether the robot got there, and saw nothing new
  void add(const Eigen::Vector2d& place, const Eigen::Vector2d& viewpoint, double until,
           bool reached);

  /// What has only been looked at in vain, less often than `max_attempts`, may be tried again now;
  /// what was not reached must wait, lest it is given up before anything can have changed.
  /// @return whether there are any whose time had not come
  bool release(double now, int max_attempts);

  /// Whether something waits for its time.
  [[nodiscard]] bool isWaiting(double now, int max_attempts) const;

  void move(const geometry::MapMotion& motion);
  void clear() { entries_.clear(); }
  [[nodiscard]] const std::vector<SetAside>& entries() const { return entries_; }

 private:
  [[nodiscard]] const SetAside* find(const Eigen::Vector2d& place) const;

  std::vector<SetAside> entries_;
};

}  // namespace omega_slam::exploration
