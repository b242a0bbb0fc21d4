#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/config/slam_config.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/sensing/laser_scan.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::experiments {

/// How a robot in an experiment knows where it is.
enum class LocalisationKind { kSlam, kTruth };

/// A scan, with all that is known of it.
struct TakenScan {
  const sensing::LaserScan* scan{nullptr};
  sensing::LaserMount mount;
  geometry::Pose2 T_odom_base;          ///< odometry at its stamp
  geometry::Pose2 motion_during_sweep;  ///< see sensing::ScanIntake::process
  geometry::Pose2 T_world_base;         ///< the truth at its stamp
};

/// Where the robot is believed to be, and the keyframes that its map is drawn of.
class Localisation {
 public:
  virtual ~Localisation() = default;

  virtual void take(const TakenScan& taken) = 0;

  [[nodiscard]] virtual const std::vector<slam::KeyframePtr>& keyframes() const = 0;

  /// `T_map_base` of each keyframe.
  [[nodiscard]] virtual const std::vector<geometry::Pose2>& poses() const = 0;

  /// As graph_slam publishes it; none before the first keyframe.
  [[nodiscard]] virtual std::optional<geometry::Pose2> mapFromOdom() const = 0;
};

/// By slam::Pipeline, or by the truth: then keyframes are made as often, and nothing is ever
/// corrected. What differs is due to localisation.
[[nodiscard]] std::unique_ptr<Localisation> makeLocalisation(LocalisationKind kind,
                                                             const config::SlamConfig& config);

}  // namespace omega_slam::experiments
