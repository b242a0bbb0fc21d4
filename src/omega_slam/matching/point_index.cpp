#include "omega_slam/matching/point_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace omega_slam::matching {

namespace {

constexpr double kCell = 0.07;      // [m]
constexpr std::int32_t kTurn = 64;  // cells along each axis until the grid begins anew
constexpr std::int32_t kMask = kTurn - 1;
constexpr std::int32_t kWidest = kTurn / 2 - 1;  // ring that does not yet meet itself
constexpr double kFarthest = 500000.0;           // cells from the origin; beyond, all share one
constexpr std::size_t kLikely = 2;               // so many points in a row are looked at first

/// Cells between a place's own and the farthest that a circle around it may touch; kWidest + 1 for
/// all that is too many.
std::int32_t ringsTo(double radius) {
  return static_cast<std::int32_t>(std::ceil(std::min(radius / kCell, kWidest + 1.0)));
}

}  // namespace

PointIndex::Cell PointIndex::cellOf(const Eigen::Vector2d& point) {
  // Truncation of what is never negative rounds down, and costs less than std::floor. The order of
  // the arguments makes NaN a number.
  const auto along = [](double coordinate) {
    const double cell = std::min(kFarthest, std::max(-kFarthest, coordinate / kCell));
    return static_cast<std::int32_t>(cell + kFarthest);
  };
  return {along(point.x()), along(point.y())};
}

std::size_t PointIndex::bucketOf(std::int32_t x, std::int32_t y) {
  return static_cast<std::size_t>((y & kMask) * kTurn + (x & kMask));
}

PointIndex::PointIndex(const Points& points)
    : points_(points), starts_(kTurn * kTurn + 1, 0), entries_(points.size()) {
  std::vector<std::uint32_t> buckets;
  buckets.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    const Cell cell = cellOf(point);
    buckets.push_back(static_cast<std::uint32_t>(bucketOf(cell.x, cell.y)));
    ++starts_[buckets.back()];
  }
  // A counting sort: first each bucket's end; filling them backwards leaves the starts.
  std::uint32_t end = 0;
  for (std::uint32_t& start : starts_) {
    end += start;
    start = end;
  }
  for (std::size_t i = points.size(); i-- > 0;) {
    entries_[--starts_[buckets[i]]] = {points[i], i};
  }
}

template <class Visitor>
void PointIndex::visitRow(std::int32_t y, std::int32_t first_x, std::int32_t last_x,
                          Visitor visit) const {
  const auto visitRun = [&](std::size_t first_bucket, std::size_t last_bucket) {
    for (std::uint32_t i = starts_[first_bucket]; i < starts_[last_bucket + 1]; ++i) {
      visit(entries_[i]);
    }
  };
  const std::size_t first = bucketOf(first_x, y);
  const std::size_t last = bucketOf(last_x, y);
  if (first <= last) {
    visitRun(first, last);
  } else {  // across the seam
    visitRun(first, bucketOf(kMask, y));
    visitRun(bucketOf(0, y), last);
  }
}

std::optional<PointIndex::Nearest> PointIndex::nearest(
    const Eigen::Vector2d& query, double reach, const std::array<std::size_t, 2>& likely) const {
  constexpr auto kNone = std::numeric_limits<std::size_t>::max();
  std::size_t best = kNone;
  double smallest = reach * reach;
  double next = smallest;
  const auto visit = [&](const Entry& entry) {
    const double squared = (entry.point - query).squaredNorm();
    if (squared < smallest || (squared == smallest && best == kNone)) {
      next = smallest;
      smallest = squared;
      best = entry.index;
    } else if (squared < next && entry.index != best) {
      next = squared;
    }
  };
  for (const std::size_t first : likely) {
    for (std::size_t i = first; i < points_.size() && i < first + kLikely; ++i) {
      visit({points_[i], i});
    }
  }
  if (ringsTo(reach) > kWidest) {
    std::for_each(entries_.begin(), entries_.end(), visit);
  } else {
    const double unseen = searchRings(query, ringsTo(reach), smallest, visit);
    next = std::min(next, unseen);
  }
  if (best == kNone) {
    return std::nullopt;
  }
  return Nearest{best, smallest, next};
}

/// Visits what may be nearer than the smallest squared distance so far.
/// @return [m^2] nothing within the rings that was not visited is nearer
template <class Visitor>
double PointIndex::searchRings(const Eigen::Vector2d& query, std::int32_t rings,
                               const double& smallest, Visitor visit) const {
  const Cell cell = cellOf(query);
  const Eigen::Vector2d corner((cell.x - kFarthest) * kCell, (cell.y - kFarthest) * kCell);
  const Eigen::Vector2d below = query - corner;  // to the cell's own borders
  const Eigen::Vector2d above = Eigen::Vector2d::Constant(kCell) - below;
  double unseen = std::numeric_limits<double>::infinity();
  visitRow(cell.y, cell.x, cell.x, visit);
  for (std::int32_t ring = 1; ring <= rings; ++ring) {
    const auto isClose = [&](double to_own_border) {
      const double gap = std::max(0.0, to_own_border + (ring - 1) * kCell);
      const bool is_close = gap * gap <= smallest;
      unseen = is_close ? unseen : std::min(unseen, gap * gap);
      return is_close;
    };
    const bool down = isClose(below.y());
    const bool up = isClose(above.y());
    const bool left = isClose(below.x());
    const bool right = isClose(above.x());
    if (!down && !up && !left && !right) {
      break;
    }
    if (down) {
      visitRow(cell.y - ring, cell.x - ring, cell.x + ring, visit);
    }
    if (up) {
      visitRow(cell.y + ring, cell.x - ring, cell.x + ring, visit);
    }
    for (std::int32_t y = cell.y - ring + 1; y < cell.y + ring; ++y) {
      if (left) {
        visitRow(y, cell.x - ring, cell.x - ring, visit);
      }
      if (right) {
        visitRow(y, cell.x + ring, cell.x + ring, visit);
      }
    }
  }
  return unseen;
}

void PointIndex::within(const Eigen::Vector2d& query, double radius,
                        std::vector<Neighbour>& neighbours) const {
  neighbours.clear();
  const auto visit = [&](const Entry& entry) {
    const double squared = (entry.point - query).squaredNorm();
    if (squared <= radius * radius) {
      neighbours.push_back({entry.index, squared});
    }
  };
  const std::int32_t reach = ringsTo(radius);
  if (reach > kWidest) {
    std::for_each(entries_.begin(), entries_.end(), visit);
    return;
  }
  const Cell center = cellOf(query);
  for (std::int32_t y = center.y - reach; y <= center.y + reach; ++y) {
    visitRow(y, center.x - reach, center.x + reach, visit);
  }
}

}  // namespace omega_slam::matching
