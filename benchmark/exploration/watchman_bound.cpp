#include "exploration/watchman_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "exploration/coverage.h"
#include "exploration/held_karp.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::experiments {
namespace {

using grid::Cell;

constexpr int kRays = 512;             // from a place, all round
constexpr int kRim = 1;                // [cells] that a region is taken too large
constexpr int kPlaceStep = 5;          // [cells] between places that may be witnesses
constexpr std::size_t kChoice = 4000;  // places that are seen from the fewest others, of which
constexpr std::size_t kMost = 100;     // so many may be witnesses,
constexpr double kApart = 0.3;         // [m] with their regions so far from each other
constexpr double kOctile = 1.0824;     // ways in eight directions are at most so much longer
constexpr float kFar = std::numeric_limits<float>::infinity();

/// The cells that the robot can stand on, what is in sight from where, and ways between them.
class Floor {
 public:
  Floor(const simulation::World& world, const Eigen::Vector2d& start, double radius, double sight)
      : world_(world), sight_(sight), room_(world.geometry().size(), false) {
    const double half_diagonal = 0.5 * std::sqrt(2.0) * geometry().resolution;
    for (const Eigen::Vector2d& place : standingRoom(world, start, radius - half_diagonal)) {
      room_[geometry().index(geometry().cellAt(place))] = true;
    }
  }

  [[nodiscard]] const grid::GridGeometry& geometry() const { return world_.geometry(); }

  /// The cells to stand on from which a place is in sight; each once.
  [[nodiscard]] std::vector<std::size_t> regionOf(const Eigen::Vector2d& place) const {
    std::vector<std::size_t> region;
    std::vector<bool> met(geometry().size(), false);
    for (int i = 0; i < kRays; ++i) {
      const double angle = 2.0 * geometry::kPi * i / kRays;
      const auto hit = world_.castRay(place, angle, sight_);
      const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
      grid::traverseRay(geometry(), place, place + (hit ? hit->range : sight_) * way,
                        [&](const Cell& cell) { addAbout(cell, met, region); });
    }
    return region;
  }

  /// [m] in eight directions from the nearest cell of a region; Dijkstra's search.
  [[nodiscard]] std::vector<float> distancesFrom(const std::vector<std::size_t>& region) const {
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<float> distances(geometry().size(), kFar);
    for (const std::size_t index : region) {
      distances[index] = 0.0F;
      open.emplace(0.0F, index);
    }
    const auto width = static_cast<std::size_t>(geometry().width);
    while (!open.empty()) {
      const auto [distance, index] = open.top();
      open.pop();
      if (distance > distances[index]) {
        continue;
      }
      const Cell cell(static_cast<int>(index % width), static_cast<int>(index / width));
      for (int step = 0; step < 9; ++step) {
        const Cell way(step % 3 - 1, step / 3 - 1);
        if (!isRoom(cell + way)) {
          continue;
        }
        const std::size_t next = geometry().index(cell + way);
        const auto longer =
            static_cast<float>(distance + geometry().resolution * std::sqrt(way.squaredNorm()));
        if (longer < distances[next]) {
          distances[next] = longer;
          open.emplace(longer, next);
        }
      }
    }
    return distances;
  }

 private:
  [[nodiscard]] bool isRoom(const Cell& cell) const {
    return geometry().contains(cell) && room_[geometry().index(cell)];
  }

  void addAbout(const Cell& center, std::vector<bool>& met, std::vector<std::size_t>& to) const {
    for (int y = -kRim; y <= kRim; ++y) {
      for (int x = -kRim; x <= kRim; ++x) {
        const Cell cell = center + Cell(x, y);
        if (isRoom(cell) && !met[geometry().index(cell)]) {
          met[geometry().index(cell)] = true;
          to.push_back(geometry().index(cell));
        }
      }
    }
  }

  const simulation::World& world_;
  double sight_;
  std::vector<bool> room_;
};

float leastOver(const std::vector<std::size_t>& region, const std::vector<float>& distances) {
  float least = kFar;
  for (const std::size_t index : region) {
    least = std::min(least, distances[index]);
  }
  return least;
}

struct Candidate {
  Eigen::Vector2d place;
  std::size_t seen_from;  ///< cells
};

/// Those seen from the fewest places first.
std::vector<Candidate> candidatesIn(const Floor& floor, const Seeable& seeable) {
  std::vector<Candidate> candidates;
  for (const Eigen::Vector2d& place : seeable.cells()) {
    const Cell cell = floor.geometry().cellAt(place);
    if (cell.x() % kPlaceStep == 0 && cell.y() % kPlaceStep == 0) {
      if (const std::size_t size = floor.regionOf(place).size(); size > 0) {
        candidates.push_back({place, size});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.seen_from < b.seen_from; });
  candidates.resize(std::min(candidates.size(), kChoice));
  return candidates;
}

/// Places that may be witnesses, and the least distances [m] between regions.
struct Pool {
  std::vector<Eigen::Vector2d> places;
  Eigen::MatrixXd distances;
};

Pool poolFrom(const Floor& floor, const std::vector<Candidate>& candidates) {
  Pool pool;
  std::vector<std::vector<std::size_t>> regions;
  std::vector<std::vector<float>> fields;
  std::vector<float> nearest(floor.geometry().size(), kFar);
  for (const Candidate& candidate : candidates) {
    auto region = floor.regionOf(candidate.place);
    if (regions.size() == kMost || static_cast<double>(leastOver(region, nearest)) < kApart) {
      continue;
    }
    pool.places.push_back(candidate.place);
    fields.push_back(floor.distancesFrom(region));
    regions.push_back(std::move(region));
    std::transform(nearest.begin(), nearest.end(), fields.back().begin(), nearest.begin(),
                   [](float a, float b) { return std::min(a, b); });
  }
  const auto count = static_cast<Eigen::Index>(regions.size());
  pool.distances.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      pool.distances(i, k) = leastOver(regions[static_cast<std::size_t>(std::max(i, k))],
                                       fields[static_cast<std::size_t>(std::min(i, k))]);
    }
  }
  return pool;
}

double boundOf(const Pool& pool, const std::vector<Eigen::Index>& chosen) {
  const auto count = static_cast<Eigen::Index>(chosen.size());
  Eigen::MatrixXd distances(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      distances(i, k) =
          pool.distances(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(k)]);
    }
  }
  return tourBound(distances) / kOctile;
}

/// Any choice gives a bound. One witness after the other is taken in or left out, whichever makes
/// it greatest, as long as any does: regions that are wide help little, and are short cuts.
WatchmanBound greatestBound(const Pool& pool) {
  WatchmanBound best;
  if (pool.places.size() < 2) {
    return best;
  }
  std::vector<Eigen::Index> chosen(2);
  pool.distances.maxCoeff(&chosen[0], &chosen[1]);
  best.length = boundOf(pool, chosen);
  for (bool better = true; better;) {
    better = false;
    std::vector<Eigen::Index> choice = chosen;
    for (Eigen::Index i = 0; i < pool.distances.rows(); ++i) {
      std::vector<Eigen::Index> other = chosen;
      const auto taken = std::find(other.begin(), other.end(), i);
      taken == other.end() ? other.push_back(i) : void(other.erase(taken));
      if (const double bound = boundOf(pool, other); bound > best.length + 1e-3) {
        best.length = bound;
        choice = std::move(other);
        better = true;
      }
    }
    chosen = std::move(choice);
  }
  for (const Eigen::Index i : chosen) {
    best.witnesses.push_back(pool.places[static_cast<std::size_t>(i)]);
  }
  return best;
}

}  // namespace

WatchmanBound watchmanBound(const simulation::World& world, const Eigen::Vector2d& start,
                            double radius, double sight) {
  const Floor floor(world, start, radius, sight);
  const auto candidates = candidatesIn(floor, Seeable(world, start, radius, sight));
  return greatestBound(poolFrom(floor, candidates));
}

}  // namespace omega_slam::experiments
