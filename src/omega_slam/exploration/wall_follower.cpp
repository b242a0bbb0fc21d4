#include "omega_slam/exploration/wall_follower.h"

#include <array>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::exploration {
namespace {

using geometry::Pose2;

constexpr double kStep = 0.5;     // [m]
constexpr double kWayOut = 1.0;   // [m] from a place without room to one with
constexpr double kBeside = 0.25;  // [m] nearer than this is as good as there, where robots arrive
constexpr std::size_t kDirections = 24;
constexpr double kDirection = 2.0 * geometry::kPi / kDirections;  // [rad]

/// A step in a direction [rad].
Pose2 stepFrom(const Pose2& T_map_base, double heading) {
  return {T_map_base.x + kStep * std::cos(heading), T_map_base.y + kStep * std::sin(heading),
          geometry::normalizeAngle(heading)};
}

/// The cell of the robot itself may be too close to the wall; it is there nevertheless.
bool isClear(const StandingRoom& room, const Pose2& from, const Pose2& to) {
  const Cell start = room.geometry().cellAt(from.translation());
  bool clear = true;
  grid::traverseRay(room.geometry(), from.translation(), to.translation(), [&](const Cell& cell) {
    clear = clear && (cell == start || room.hasRoomAt(cell + room.corner()));
  });
  return clear;
}

/// Where there is room, the pose itself; else the nearest place with room.
std::optional<Pose2> nearestWithRoom(const StandingRoom& room, const Pose2& pose) {
  if (room.hasRoomAt(room.geometry().cellAt(pose.translation()) + room.corner())) {
    return pose;
  }
  const auto out = room.nearestRoom(pose.translation(), kWayOut);
  if (out.empty()) {
    return std::nullopt;
  }
  const Eigen::Vector2d place = room.geometry().center(out.front() - room.corner());
  return Pose2{place.x(), place.y(), pose.theta};
}

}  // namespace

std::optional<Pose2> WallFollower::next(const StandingRoom& room, const Pose2& T_map_base) {
  const auto begin = nearestWithRoom(room, T_map_base);
  if (!begin || geometry::distance(*begin, T_map_base) > kBeside) {
    return begin;  // to be driven to first
  }
  double heading = begin->theta;
  if (std::uniform_real_distribution<double>(0.0, 1.0)(random_) < switch_probability_) {
    on_the_right_ = !on_the_right_;
    crossing_ = true;
    heading += on_the_right_ ? -geometry::kPi / 2.0 : geometry::kPi / 2.0;
  }
  const Pose2 straight = stepFrom(*begin, heading);
  crossing_ = crossing_ && isClear(room, *begin, straight);
  return crossing_ ? straight : alongWall(room, *begin);
}

std::optional<Pose2> WallFollower::alongWall(const StandingRoom& room,
                                             const Pose2& T_map_base) const {
  // From behind around by the side of the wall: where the wall ends, the way begins.
  const double towards_front = on_the_right_ ? 1.0 : -1.0;
  std::array<Pose2, kDirections> steps;
  std::array<bool, kDirections> clear{};
  for (std::size_t i = 0; i < kDirections; ++i) {
    steps[i] = stepFrom(T_map_base, T_map_base.theta + geometry::kPi +
                                        towards_front * static_cast<double>(i) * kDirection);
    clear[i] = isClear(room, T_map_base, steps[i]);
  }
  for (std::size_t i = 1; i <= kDirections; ++i) {
    if (!clear[i - 1] && clear[i % kDirections]) {
      return steps[i % kDirections];
    }
  }
  // No wall, or nothing else.
  return clear[0] ? std::optional<Pose2>(steps[kDirections / 2]) : std::nullopt;
}

}  // namespace omega_slam::exploration
