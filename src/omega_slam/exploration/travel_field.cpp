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

TravelField::TravelField(const StandingRoom& room, const std::vector<Cell>& start)
    : room_(&room), steps_(room.geometry().size(), kNowhere) {
  for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
    ways_[k] = static_cast<Index>(kNeighbours[k].y()) * room.geometry().width + kNeighbours[k].x();
  }
  spread(start);
}

double TravelField::reachedArea() const {
  const auto reached =
      std::count_if(steps_.begin(), steps_.end(), [](Steps steps) { return steps != kNowhere; });
  const double edge = room_->geometry().resolution;
  return static_cast<double>(reached) * edge * edge;
}

bool TravelField::canStep(Index from, std::size_t neighbour) const {
  const auto isOpen = [&](std::size_t k) { return hasRoomAt(from + ways_[k]); };
  if (neighbour < kEdgeNeighbours) {
    return isOpen(neighbour);
  }
  const std::size_t before = neighbour - kEdgeNeighbours;  // a corner lies between two edges
  return isOpen(neighbour) && isOpen(before) && isOpen((before + 1) % kEdgeNeighbours);
}

void TravelField::spread(const std::vector<Cell>& from) {
  // What is still to come lies within the cost of one step, so a ring of buckets holds it (Dial,
  // "Algorithm 360: Shortest-Path Forest with Topological Ordering", 1969).
  std::array<std::vector<Index>, kAcross + 1> ring;
  for (const Cell& cell : from) {
    at(indexOf(cell)) = 0;
    ring[0].push_back(indexOf(cell));
  }
  std::size_t waiting = from.size();
  for (Steps now = 0; waiting > 0; ++now) {
    std::vector<Index> bucket;
    bucket.swap(ring[now % ring.size()]);
    waiting -= bucket.size();
    for (const Index cell : bucket) {
      if (at(cell) != now) {
        continue;  // a shorter way was found meanwhile
      }
      for (std::size_t k = 0; k < ways_.size(); ++k) {
        const Index next = cell + ways_[k];
        const Steps steps = now + costOf(k);
        if (steps < at(next) && canStep(cell, k)) {
          at(next) = steps;
          ring[steps % ring.size()].push_back(next);
          ++waiting;
        }
      }
    }
  }
}

std::optional<double> TravelField::distanceTo(const Cell& cell) const {
  if (!room_->hasRoomAt(cell) || at(indexOf(cell)) == kNowhere) {
    return std::nullopt;
  }
  return static_cast<double>(at(indexOf(cell))) / kAlong * room_->geometry().resolution;
}

std::vector<Eigen::Vector2d> TravelField::pathTo(const Cell& cell) const {
  std::vector<Eigen::Vector2d> path;
  if (!distanceTo(cell)) {
    return path;
  }
  Cell here = cell;
  path.push_back(room_->geometry().center(here - room_->corner()));
  while (at(indexOf(here)) > 0) {
    for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
      const Cell before = here + kNeighbours[k];
      if (canStep(indexOf(here), k) && at(indexOf(before)) + costOf(k) == at(indexOf(here))) {
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
