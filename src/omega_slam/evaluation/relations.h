#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "omega_slam/evaluation/error_statistics.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/relation.h"

namespace omega_slam::evaluation {

struct RelationsOptions {
  /// [s] A pose is taken for the pose at a stamp if it is no farther away than this.
  double tolerance{0.1};
  /// [s] A stamp farther than this from both its neighbours in the trajectory is not covered.
  double max_gap{2.0};

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// How well a trajectory agrees with ground-truth relations.
struct RelationsScore {
  std::size_t relations{0};     ///< given
  std::size_t covered{0};       ///< whose two stamps the trajectory covers; the others count not
  ErrorStatistics translation;  ///< [m] of the covered ones
  ErrorStatistics rotation;     ///< [rad]
};

/// The metric of the Freiburg SLAM benchmark (Kuemmerle et al., "On measuring the accuracy of SLAM
/// algorithms", Autonomous Robots 27, 2009, equation 3): each relation is compared with the
/// relative pose that the trajectory has between the same two stamps; the error is truth^-1 *
/// estimate, of which the length and the absolute angle are averaged.
///
/// The pose at a stamp is found as the benchmark's own tool does: the nearest pose if it lies
/// within the tolerance; else that pose carried to the stamp by the odometry, where there is some;
/// else between its two neighbours.
///
/// @param trajectory `T_map_base`, finite, in any order of time
/// @param odometry `T_odom_base`, in any order, denser than the trajectory; may be empty
/// @throws std::invalid_argument for options that are not valid
[[nodiscard]] RelationsScore scoreRelations(const geometry::Trajectory& trajectory,
                                            const std::vector<graph::Relation>& relations,
                                            const geometry::Trajectory& odometry = {},
                                            const RelationsOptions& options = {});

}  // namespace omega_slam::evaluation
