#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "omega_slam/exploration/standing_room.h"
#include "omega_slam/geometry/pose2.h"

namespace omega_slam::exploration {

/// Uninformed exploration (the paper, section 4.1): keeps a hand on the wall, and now and then
/// changes the hand and crosses to the other side, lest it circle around a pillar for ever. Knows
/// the map only as far as it must to see the wall beside it. Same seed, same choices. Not
/// thread-safe.
class WallFollower {
 public:
  /// @param switch_probability [0, 1] of changing sides before a step
  WallFollower(double switch_probability, std::uint64_t seed)
      : switch_probability_(switch_probability), random_(seed) {}

  /// The end of the next step, of about half a metre: in the first direction in which there is
  /// room, from the side of the wall to the other. Far from any wall it goes straight on.
  /// @return none if there is no room for a step in any direction
  [[nodiscard]] std::optional<geometry::Pose2> next(const StandingRoom& room,
                                                    const geometry::Pose2& T_map_base);

 private:
  [[nodiscard]] std::optional<geometry::Pose2> alongWall(const StandingRoom& room,
                                                         const geometry::Pose2& T_map_base) const;

  double switch_probability_;
  std::mt19937_64 random_;
  bool on_the_right_{true};  ///< where the wall is
  bool crossing_{false};     ///< on the way to the other side
};

}  // namespace omega_slam::exploration
