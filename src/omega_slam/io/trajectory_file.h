#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/relation.h"

namespace omega_slam::io {

/// The trajectory in the TUM format, `stamp x y z qx qy qz qw` a line (s, m, unit quaternion).
/// Stamps have 6 decimals, positions and quaternions 9: equal trajectories give equal bytes.
[[nodiscard]] std::string toTum(const geometry::Trajectory& trajectory);

/// Writes it atomically. @return an empty string, or one sentence that names file and cause
[[nodiscard]] std::string writeTrajectory(const std::filesystem::path& path,
                                          const geometry::Trajectory& trajectory);

/// Reads a TUM file, in the order of the file; z is dropped, and of the orientation its yaw is
/// kept.
/// @throws std::runtime_error with one sentence that names file, line and cause
[[nodiscard]] geometry::Trajectory readTrajectory(const std::filesystem::path& path);

/// Reads odometry, `stamp x y theta` a line (s, m, m, rad), in the order of the file.
/// @throws std::runtime_error as above
[[nodiscard]] geometry::Trajectory readOdometry(const std::filesystem::path& path);

/// Reads ground-truth relations, `stamp1 stamp2 x y z roll pitch yaw` a line (s, s, m, m, m, rad):
/// the pose at stamp2 seen from the pose at stamp1. z, roll and pitch are dropped.
/// @throws std::runtime_error as above
[[nodiscard]] std::vector<graph::Relation> readRelations(const std::filesystem::path& path);

}  // namespace omega_slam::io
