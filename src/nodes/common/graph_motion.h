#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "omega_slam/geometry/map_motion.h"

namespace omega_slam {

/// How keyframes move from one pose graph to the next. Not thread-safe.
class GraphMotion {
 public:
  /// @param run of the graph; @param poses `T_map_base` of its keyframes, by id
  /// @return since the last graph; none where another run has begun, and with it another map
  std::optional<geometry::MapMotion> take(std::uint64_t run, std::vector<geometry::Pose2> poses) {
    std::swap(poses_, poses);
    const bool is_same_run = std::exchange(run_, run) == run;
    return is_same_run ? std::optional(geometry::MapMotion(std::move(poses), poses_))
                       : std::nullopt;
  }

 private:
  std::uint64_t run_{0};  ///< 0: there was none
  std::vector<geometry::Pose2> poses_;
};

}  // namespace omega_slam
