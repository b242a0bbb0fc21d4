#include "omega_slam/matching/local_map.h"

#include <algorithm>
#include <cmath>
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
constexpr double kWaySpacing = 0.4;  // [m] of the ends of beams whose ways are traced
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

Eigen::AlignedBox2d boxAround(const Reference& views) {
  Eigen::AlignedBox2d box;
  for (const View& view : views) {
    box.extend(boxAround(view));
  }
  return box;
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
  for (int odds = kLeastOdds; odds <= kMostOdds; ++odds) {
    const std::size_t byte = static_cast<std::uint8_t>(odds);
    odds_after_[byte] = static_cast<std::int8_t>(odds);
    odds_after_[256 + byte] = static_cast<std::int8_t>(std::max(odds + kMiss, kLeastOdds));
  }
  grids_.resize(static_cast<std::size_t>(config_.levels));
}

LocalMap::LocalMap(const LocalMapConfig& config, const Reference& views) : LocalMap(config) {
  Reference near = inReach(views);
  if (!near.empty()) {
    moveWindow(boxAround(near), near.back().origin);
  }
  std::for_each(near.begin(), near.end(), [this](View& view) { put(std::move(view)); });
}

bool LocalMap::insert(const View& view, const Pose2& T_map_view) {
  auto near = inReach(transformed(T_map_view, view));
  if (!near) {
    return false;
  }
  makeRoomFor(boxAround(*near), near->origin);
  put(std::move(*near));
  return true;
}

void LocalMap::redraw(const Reference& views) {
  wipe();
  Reference near = inReach(views);
  if (!near.empty()) {
    makeRoomFor(boxAround(near), near.back().origin);
  }
  std::for_each(near.begin(), near.end(), [this](View& view) { put(std::move(view)); });
}

void LocalMap::put(View view) {
  draw(view);
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

Reference LocalMap::inReach(const Reference& views_map) const {
  Reference near;
  for (const View& view : views_map) {
    if (auto seen = inReach(view)) {
      near.push_back(std::move(*seen));
    }
  }
  return near;
}

/// @param box not empty
void LocalMap::makeRoomFor(const Box& box, const Eigen::Vector2d& center) {
  if (!drawable_.contains(box)) {
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kMargin);
    moveWindow(Box(box.min() - margin, box.max() + margin).merged(drawable_), center);
  }
}

/// Lays the window anew, no farther than twice the reach from a place; what it then still covers is
/// kept. Cells are aligned with the map's origin: the map is the same wherever the window lies.
void LocalMap::moveWindow(const Box& wanted, const Eigen::Vector2d& center) {
  const Eigen::Vector2d most = Eigen::Vector2d::Constant(2.0 * config_.reach);
  drawable_ = wanted.intersection(Box(center - most, center + most));
  const double coarsest = std::ldexp(config_.resolution, config_.levels - 1);
  const Eigen::Array2d first = (drawable_.min() / coarsest).array().floor();
  const Eigen::Array2d last = (drawable_.max() / coarsest).array().floor();
  const grid::Cell size = (last - first).cast<int>() + 3;  // a border of one stays empty
  const Eigen::Vector2d origin = (first - 1.0) * coarsest;
  const Eigen::Array2d way = (grids_.back().geometry.origin - origin) / coarsest;
  const grid::Cell shift = way.round().cast<int>();
  const CellBox inside(grid::Cell(1, 1), size.array() - 2);
  const CellBox kept = drawn_.intersection(CellBox(inside.min() - shift, inside.max() - shift));
  evidence_ = evidence_.moved(kept, size, shift, config_.levels - 1);
  for (std::size_t level = 0; level < grids_.size(); ++level) {
    const int split = splitAt(level);
    const CellBox box = splitCells(kept, split);
    const grid::GridGeometry to{coarsest / split, origin, size.x() * split, size.y() * split};
    ValueGrid& grid = grids_[level];
    grid.values = movedCells(box, grid.geometry, grid.values, to, split * shift);
    grid.geometry = to;
  }
  drawn_ = kept.isEmpty() ? CellBox() : CellBox(kept.min() + shift, kept.max() + shift);
}

/// Back to an empty map, but with its window.
void LocalMap::wipe() {
  recent_views_.clear();
  evidence_.forEachStretch(drawn_, [](Evidence* cells, std::size_t count) {
    std::memset(cells, 0, count * sizeof(Evidence));
  });
  for (std::size_t level = 0; level < grids_.size(); ++level) {
    ValueGrid& grid = grids_[level];
    zeroCells(splitCells(drawn_, splitAt(level)), grid.geometry, grid.values);
  }
  drawn_.setEmpty();
}

/// Cells of a level that are as wide as one of the coarsest.
int LocalMap::splitAt(std::size_t level) const { return 1 << (grids_.size() - 1 - level); }

bool LocalMap::isFreeAround(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p_grid = inCells(p_map);
  const grid::GridGeometry& finest = grids_.front().geometry;
  if (!(p_grid.x() >= 0.0 && p_grid.y() >= 0.0 && p_grid.x() < finest.width &&
        p_grid.y() < finest.height)) {
    return false;
  }
  const grid::Cell cell = p_grid.cast<int>();
  if (evidence_(cell).odds >= kFreeOdds) {
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
  noteDrawn(boxAround(view).intersection(drawable_));
  drawWalls(view.points);
  if (drawable_.contains(view.origin)) {
    drawBeams(view);
  }
}

void LocalMap::drawWalls(const Points& points) {
  const Eigen::Vector2d* before = nullptr;
  Eigen::Vector2d start;  // [cells], of the point before
  for (const Eigen::Vector2d& point : points) {
    if (!drawable_.contains(point)) {
      before = nullptr;
      continue;
    }
    const Eigen::Vector2d end = inCells(point);
    const bool wall_goes_on =
        before != nullptr && (point - *before).squaredNorm() < kSameWall * kSameWall;
    drawWall(wall_goes_on ? start : end, end);
    before = &point;
    start = end;
  }
}

void LocalMap::drawBeams(const View& view) {
  const Eigen::Vector2d laser = inCells(view.origin);
  const Eigen::Vector2d* traced = nullptr;
  for (const Eigen::Vector2d& point : view.points) {
    const bool is_close =
        traced != nullptr && (point - *traced).squaredNorm() < kWaySpacing * kWaySpacing;
    if (!is_close && drawable_.contains(point)) {
      drawBeam(laser, inCells(point));
      traced = &point;
    }
  }
}

/// Whatever of a place is drawn, and a beam may pass beside it by a cell.
void LocalMap::noteDrawn(const Box& box) {
  if (!box.isEmpty()) {
    const ValueGrid& coarsest = grids_.back();
    drawn_.extend(CellBox(coarsest.geometry.cellAt(box.min()).array() - 1,
                          coarsest.geometry.cellAt(box.max()).array() + 1));
  }
}

/// A cell that bears the number of the newest view has been changed by it.
void LocalMap::numberView() {
  if (number_ == std::numeric_limits<decltype(number_)>::max()) {
    evidence_.forEachStretch(drawn_, [](Evidence* cells, std::size_t count) {
      std::for_each(cells, cells + count, [](Evidence& evidence) { evidence.claim = 0; });
    });
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
  const Eigen::Vector2d way = end - start;
  const int steps = static_cast<int>(std::ceil(std::max(std::abs(way.x()), std::abs(way.y()))));
  const Eigen::Vector2d step = way / std::max(steps, 1);
  for (int i = 0; i <= steps; ++i) {
    const grid::Cell cell(static_cast<int>(start.x() + i * step.x()),
                          static_cast<int>(start.y() + i * step.y()));
    Evidence& evidence = evidence_(cell);
    if (evidence.claim != number_) {
      evidence.claim = number_;
      evidence.odds = static_cast<std::int8_t>(std::min(evidence.odds + kHit, kMostOdds));
      refresh(cell, evidence.odds);
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
  const auto cells = evidence_.along(major);
  const std::uint8_t number = number_;
  for (int along = first; along != last; along += step, place += rise) {
    const std::int64_t across = place >> 32;
    Evidence& evidence = cells.at(along, across);
    const int before = evidence.odds;
    const bool is_first = evidence.claim != number;
    // Looked up: nobody could foretell a branch, until a wall is met.
    evidence = {odds_after_[(is_first ? 256U : 0U) + static_cast<std::uint8_t>(before)], number};
    if (before > 0 && is_first) {
      const grid::Cell cell(along, static_cast<int>(across));
      refresh(major == 0 ? cell : cell.reverse(), evidence.odds);
    }
  }
}

/// Carries what is now known of a cell to the values of all grids.
void LocalMap::refresh(const grid::Cell& cell, int odds) {
  std::uint8_t value = values_by_odds_[static_cast<std::size_t>(std::max(odds, 0))];
  for (std::size_t level = 0;; ++level) {
    ValueGrid& grid = grids_[level];
    const auto width = static_cast<std::size_t>(grid.geometry.width);
    const std::size_t column = static_cast<std::size_t>(cell.x()) >> level;
    const std::size_t row = static_cast<std::size_t>(cell.y()) >> level;
    std::uint8_t& there = grid.values[row * width + column];
    if (there == value) {
      return;
    }
    there = value;
    if (level + 1 == grids_.size()) {
      return;
    }
    // Of the four that the next level has for one.
    const std::uint8_t* const low =
        &grid.values[(row & ~std::size_t{1}) * width + (column & ~std::size_t{1})];
    const std::uint8_t* const high = low + width;
    value = std::max(std::max(low[0], low[1]), std::max(high[0], high[1]));
  }
}

}  // namespace omega_slam::matching
