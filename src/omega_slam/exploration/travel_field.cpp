#include "omega_slam/exploration/travel_field.h"

#include <algorithm>
#include <array>
#include <limits>

namespace omega_slam::exploration {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kAlong = 5;
constexpr std::uint32_t kAcross = 7;

constexpr std::uint32_t costOf(std::size_t neighbour) {
  return neighbour < kEdgeNeighbours ? kAlong : kAcross;
}

}  // namespace

TravelField::TravelField(const StandingRoom& room, const Eigen::Vector2d& start, double snap)
    : room_(&room), steps_(room.geometry().size(), kNowhere) {
  spread(room.nearestRoom(start, snap));
}

bool TravelField::canStep(const Cell& from, std::size_t neighbour) const {
  const Cell step = kNeighbours[neighbour];
  return room_->hasRoomAt(from + step) &&
         (neighbour < kEdgeNeighbours || (room_->hasRoomAt(from + Cell(step.x(), 0)) &&
                                          room_->hasRoomAt(from + Cell(0, step.y()))));
}

void TravelField::spread(const std::vector<Cell>& from) {
  // What is still to come lies within the cost of one step, so a ring of buckets holds it (Dial,
  // "Algorithm 360: Shortest-Path Forest with Topological Ordering", 1969).
  std::array<std::vector<Cell>, kAcross + 1> ring;
  for (const Cell& cell : from) {
    at(cell) = 0;
    ring[0].push_back(cell);
  }
  std::size_t waiting = from.size();
  for (Steps now = 0; waiting > 0; ++now) {
    std::vector<Cell> bucket;
    bucket.swap(ring[now % ring.size()]);
    waiting -= bucket.size();
    for (const Cell& cell : bucket) {
      if (at(cell) != now) {
        continue;  // a shorter way was found meanwhile
      }
      for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
        const Cell next = cell + kNeighbours[k];
        const Steps steps = now + costOf(k);
        if (canStep(cell, k) && steps < at(next)) {
          at(next) = steps;
          ring[steps % ring.size()].push_back(next);
          ++waiting;
        }
      }
    }
  }
}

std::optional<double> TravelField::distanceTo(const Cell& cell) const {
  if (!room_->hasRoomAt(cell) || at(cell) == kNowhere) {
    return std::nullopt;
  }
  return static_cast<double>(at(cell)) / kAlong * room_->geometry().resolution;
}

std::vector<Eigen::Vector2d> TravelField::pathTo(const Cell& cell) const {
  std::vector<Eigen::Vector2d> path;
  if (!distanceTo(cell)) {
    return path;
  }
  Cell here = cell;
  path.push_back(room_->geometry().center(here - room_->corner()));
  while (at(here) > 0) {
    for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
      const Cell before = here + kNeighbours[k];
      if (canStep(here, k) && at(before) + costOf(k) == at(here)) {
        here = before;
        break;
      }
    }
    path.push_back(room_->geometry().center(here - room_->corner()));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace omega_slam::exploration
