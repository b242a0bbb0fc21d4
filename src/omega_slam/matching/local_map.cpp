#include "omega_slam/matching/local_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

// Log odds in units of 0.2: an end is right with probability 0.9, a way through with 0.7.
constexpr double kOddsUnit = 0.2;
constexpr int kHit = 11;
constexpr int kMiss = -4;
constexpr int kFreeOdds = 3 * kMiss;  // a cell that is less likely was seen through
constexpr int kLeastOdds = -40;       // a wall that appears is believed after four views
constexpr int kMostOdds = 63;         // one that has gone, after sixteen

constexpr double kSameWall = 0.2;    // [m] neighbouring returns closer than this are on one wall
constexpr double kWaySpacing = 0.1;  // [m] of the ends of beams whose ways are traced
constexpr double kMargin = 10.0;     // [m] that the window is wider than what it has to hold
constexpr double kFarthest = 1e6;    // [m] from the map's origin, where doubles are 0.1 nm apart
constexpr double kMostCells = 8192;  // along an edge of the finest grid

Eigen::AlignedBox2d boxAround(const View& view) {
  Eigen::AlignedBox2d box(view.origin);
  for (const Eigen::Vector2d& point : view.points) {
    box.extend(point);
  }
  return box;
}

/// @param size [bytes] above 0
bool isZero(const void* memory, std::size_t size) {
  const auto* const bytes = static_cast<const unsigned char*>(memory);
  return bytes[0] == 0 && std::memcmp(bytes, bytes + 1, size - 1) == 0;  // each is as the next
}

/// The cells of one grid as those of another, as far as that has them inside of its border.
/// @param from of the same resolution; its cells coincide with those of the other
template <typename CellType>
ZeroedCells<CellType> movedTo(const grid::GridGeometry& to, const grid::GridGeometry& from,
                              const ZeroedCells<CellType>& cells, int border) {
  ZeroedCells<CellType> moved(to.size());
  const Eigen::Vector2d way = (from.origin - to.origin) / to.resolution;
  const grid::Cell shift = way.array().round().cast<int>();
  const grid::Cell low = shift.cwiseMax(border);
  const grid::Cell high = (shift + grid::Cell(from.width, from.height))
                              .cwiseMin(grid::Cell(to.width - border, to.height - border));
  if (low.x() >= high.x()) {
    return moved;
  }
  for (int row = low.y(); row < high.y(); ++row) {
    const CellType* const begin = &cells[from.index(grid::Cell(low.x(), row) - shift)];
    const std::size_t bytes = static_cast<std::size_t>(high.x() - low.x()) * sizeof(CellType);
    if (!isZero(begin, bytes)) {
      std::memcpy(&moved[to.index({low.x(), row})], begin, bytes);
    }
  }
  return moved;
}

}  // namespace

std::vector<std::string> LocalMapConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("resolution", resolution, 0.001, 10.0);
  violations.requireWithin("levels", levels, 1, 8);
  // The window spans the reach twice to each side.
  violations.requireWithin("reach", reach, resolution, 0.25 * kMostCells * resolution);
  return violations.sentences();
}

LocalMap::LocalMap(const LocalMapConfig& config) : config_(config) {
  geometry::throwIfAny(config_.validate());
  for (std::size_t odds = 0; odds < values_by_odds_.size(); ++odds) {
    // p - (1 - p), where p has these odds
    const double value = std::tanh(0.5 * kOddsUnit * static_cast<double>(odds));
    values_by_odds_[odds] = static_cast<std::uint8_t>(std::lround(ValueGrid::kMost * value));
  }
  grids_.resize(static_cast<std::size_t>(config_.levels));
}

LocalMap::LocalMap(const LocalMapConfig& config, const Reference& views) : LocalMap(config) {
  Reference known;
  Box box;
  for (const View& view : views) {
    if (auto near = inReach(view)) {
      box.extend(boxAround(*near));
      known.push_back(std::move(*near));
    }
  }
  if (!known.empty()) {
    moveWindow(box, known.back().origin);
  }
  for (View& view : known) {
    draw(view);
    remember(std::move(view));
  }
}

bool LocalMap::insert(const View& view, const Pose2& T_map_view) {
  auto near = inReach(transformed(T_map_view, view));
  if (!near) {
    return false;
  }
  Box box = boxAround(*near);
  if (!drawable_.contains(box)) {
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kMargin);
    box = Box(box.min() - margin, box.max() + margin);
    moveWindow(box.merged(drawable_), near->origin);
  }
  draw(*near);
  remember(std::move(*near));
  return true;
}

void LocalMap::remember(View view) {
  if (recent_views_.size() == kRecentViews) {
    recent_views_.erase(recent_views_.begin());
  }
  recent_views_.push_back(std::move(view));
}

void LocalMap::clear() { *this = LocalMap(config_); }

/// The view without the points that are out of reach or not finite; none if its laser is.
std::optional<View> LocalMap::inReach(const View& view_map) const {
  if (!(view_map.origin.cwiseAbs().maxCoeff() <= kFarthest)) {
    return std::nullopt;
  }
  View near;
  near.origin = view_map.origin;
  near.points.reserve(view_map.points.size());
  for (const Eigen::Vector2d& point : view_map.points) {
    if ((point - near.origin).squaredNorm() <= config_.reach * config_.reach) {
      near.points.push_back(point);
    }
  }
  return near;
}

/// Lays the window anew, no farther than twice the reach from a place; what it then still covers is
/// kept. Cells are aligned with the map's origin: the map is the same wherever the window lies.
void LocalMap::moveWindow(const Box& wanted, const Eigen::Vector2d& center) {
  const Eigen::Vector2d most = Eigen::Vector2d::Constant(2.0 * config_.reach);
  drawable_ = wanted.intersection(Box(center - most, center + most));
  const double coarsest = std::ldexp(config_.resolution, config_.levels - 1);
  const Eigen::Array2d first = (drawable_.min() / coarsest).array().floor();
  const Eigen::Array2d last = (drawable_.max() / coarsest).array().floor();
  const grid::GridGeometry before = grids_.front().geometry;
  for (std::size_t level = 0; level < grids_.size(); ++level) {
    const int split =
        1 << (grids_.size() - 1 - level);  // into so many, a border of one stays empty
    grid::GridGeometry geometry;
    geometry.resolution = coarsest / split;
    geometry.origin = (first - 1.0) * coarsest;
    geometry.width = (static_cast<int>(last.x() - first.x()) + 3) * split;
    geometry.height = (static_cast<int>(last.y() - first.y()) + 3) * split;
    ValueGrid& grid = grids_[level];
    grid.values = movedTo(geometry, grid.geometry, grid.values, split);
    grid.geometry = geometry;
    if (level == 0) {
      evidence_ = movedTo(geometry, before, evidence_, split);
    }
  }
}

bool LocalMap::isFreeAround(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p_grid = inCells(p_map);
  const grid::GridGeometry& finest = grids_.front().geometry;
  if (!(p_grid.x() >= 0.0 && p_grid.y() >= 0.0 && p_grid.x() < finest.width &&
        p_grid.y() < finest.height)) {
    return false;
  }
  const grid::Cell cell = p_grid.cast<int>();
  if (evidence_[finest.index(cell)].odds >= kFreeOdds) {
    return false;
  }
  const ValueGrid& coarsest = grids_.back();
  const grid::Cell middle = cell / (1 << (grids_.size() - 1));
  const grid::Cell size(coarsest.geometry.width, coarsest.geometry.height);
  const grid::Cell low = (middle.array() - 1).max(0);
  const grid::Cell high = (middle.array() + 2).min(size.array());
  for (int row = low.y(); row < high.y(); ++row) {
    const auto* const first = &coarsest.values[coarsest.geometry.index({low.x(), row})];
    if (std::any_of(first, first + (high.x() - low.x()), [](auto value) { return value > 0; })) {
      return false;
    }
  }
  return true;
}

void LocalMap::draw(const View& view) {
  numberView();
  const Points& points = view.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!drawable_.contains(points[i])) {
      continue;
    }
    const bool wall_goes_on = i > 0 && drawable_.contains(points[i - 1]) &&
                              (points[i] - points[i - 1]).squaredNorm() < kSameWall * kSameWall;
    drawWall(inCells(wall_goes_on ? points[i - 1] : points[i]), inCells(points[i]));
  }
  if (!drawable_.contains(view.origin)) {
    return;
  }
  const Eigen::Vector2d* traced = nullptr;
  for (const Eigen::Vector2d& point : points) {
    const bool is_close =
        traced != nullptr && (point - *traced).squaredNorm() < kWaySpacing * kWaySpacing;
    if (!is_close && drawable_.contains(point)) {
      drawBeam(inCells(view.origin), inCells(point));
      traced = &point;
    }
  }
}

/// A cell that bears the number of the newest view has been changed by it.
void LocalMap::numberView() {
  if (number_ == std::numeric_limits<std::uint16_t>::max()) {
    for (Evidence& evidence : evidence_) {
      evidence.claim = 0;
    }
    number_ = 0;
  }
  ++number_;
}

Eigen::Vector2d LocalMap::inCells(const Eigen::Vector2d& p_map) const {
  const grid::GridGeometry& finest = grids_.front().geometry;
  return (p_map - finest.origin) / finest.resolution;
}

/// @param start, end [cells]; the same for a return that stands alone
void LocalMap::drawWall(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  const int steps = static_cast<int>(std::ceil((end - start).cwiseAbs().maxCoeff()));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps > 0 ? static_cast<double>(i) / steps : 1.0;
    const grid::Cell cell = (start + share * (end - start)).cast<int>();
    Evidence& evidence = evidence_[grids_.front().geometry.index(cell)];
    if (evidence.claim != number_) {
      evidence.claim = number_;
      evidence.odds = static_cast<std::int16_t>(std::min(evidence.odds + kHit, kMostOdds));
      refresh(cell);
    }
  }
}

/// One cell for each step along the longer axis, as Bresenham draws a line, without the last.
/// (grid::traverseCells, which leaves out none that the beam touches, takes three times as long.)
void LocalMap::drawBeam(const Eigen::Vector2d& laser, const Eigen::Vector2d& end) {
  const Eigen::Vector2d way = end - laser;
  const int major = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
  const int minor = 1 - major;
  const int first = static_cast<int>(laser[major]);
  const int last = static_cast<int>(end[major]);
  if (first == last) {
    return;
  }
  const int step = last < first ? -1 : 1;
  // Where the beam passes the middle of a major cell, with 32 bits behind the point.
  constexpr double kOne = 4294967296.0;
  const double slope = way[minor] / way[major];
  auto place =
      static_cast<std::int64_t>((laser[minor] + slope * (first + 0.5 - laser[major])) * kOne);
  const auto rise = static_cast<std::int64_t>(slope * step * kOne);
  const std::int64_t width = grids_.front().geometry.width;
  const std::int64_t along_stride = major == 0 ? 1 : width;
  const std::int64_t across_stride = major == 0 ? width : 1;
  Evidence* const cells = evidence_.begin();
  const std::uint16_t number = number_;
  for (int along = first; along != last; along += step, place += rise) {
    const std::int64_t across = place >> 32;
    Evidence& evidence = cells[along * along_stride + across * across_stride];
    const int before = evidence.odds;
    // What can't become less likely, as most cells, needs no claim either: it is no wall's.
    if (before == kLeastOdds || evidence.claim == number) {
      continue;
    }
    evidence.claim = number;
    evidence.odds = static_cast<std::int16_t>(std::max(before + kMiss, kLeastOdds));
    if (before > 0) {
      grid::Cell cell;
      cell[major] = along;
      cell[minor] = static_cast<int>(across);
      refresh(cell);
    }
  }
}

/// Carries what is now known of a cell to the values of all grids.
void LocalMap::refresh(grid::Cell cell) {
  const int odds = evidence_[grids_.front().geometry.index(cell)].odds;
  std::uint8_t value = values_by_odds_[static_cast<std::size_t>(std::max(odds, 0))];
  for (std::size_t level = 0;; ++level) {
    ValueGrid& grid = grids_[level];
    std::uint8_t& there = grid.values[grid.geometry.index(cell)];
    if (there == value) {
      return;
    }
    there = value;
    if (level + 1 == grids_.size()) {
      return;
    }
    cell /= 2;
    const std::uint8_t* const low = &grid.values[grid.geometry.index(2 * cell)];
    const std::uint8_t* const high = low + grid.geometry.width;
    value = std::max({low[0], low[1], high[0], high[1]});
  }
}

}  // namespace omega_slam::matching
