#include "omega_slam/mapping/occupancy_mapper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace omega_slam::mapping {
namespace {

using grid::Cell;

using Box = Eigen::AlignedBox<int, 2>;

std::size_t columns(const Box& box) { return static_cast<std::size_t>(box.sizes().x()) + 1; }

std::size_t cellCount(const Box& box) {
  return columns(box) * (static_cast<std::size_t>(box.sizes().y()) + 1);
}

/// Row-major index of a cell among those of a box that holds it.
std::size_t indexIn(const Box& box, const Cell& cell) {
  return static_cast<std::size_t>(cell.y() - box.min().y()) * columns(box) +
         static_cast<std::size_t>(cell.x() - box.min().x());
}

bool isPositive(double value) { return std::isfinite(value) && value > 0.0; }

}  // namespace

std::vector<std::string> OccupancyMapperConfig::validate() const {
  std::vector<std::string> faults;
  const auto require = [&faults](bool good, const std::string& sentence) {
    if (!good) {
      faults.push_back(sentence);
    }
  };
  require(isPositive(resolution),
          fmt::format("resolution must be above 0 m, but it is {}.", resolution));
  require(std::isfinite(max_range) && max_range >= 0.0,
          fmt::format("max_range must be 0 (no limit) or above, but it is {}.", max_range));
  require(occupied_threshold > 0.0 && occupied_threshold <= 1.0,
          fmt::format("occupied_threshold must be above 0 and at most 1, but it is {}.",
                      occupied_threshold));
  require(min_observations >= 1,
          fmt::format("min_observations must be 1 or more, but it is {}.", min_observations));
  require(isPositive(max_extent),
          fmt::format("max_extent must be above 0 m, but it is {}.", max_extent));
  const std::vector<std::string> more = renderer.validate();
  faults.insert(faults.end(), more.begin(), more.end());
  return faults;
}

OccupancyMapper::OccupancyMapper(const OccupancyMapperConfig& config) : config_(config) {
  const std::vector<std::string> faults = config.validate();
  if (!faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  renderer_ = makeRenderer(config.renderer);
}

std::string OccupancyMapper::add(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base) {
  if (std::string reason =
          placeRays(sweep, T_map_base, config_.resolution, config_.max_range, rays_);
      !reason.empty()) {
    return reason;
  }
  if (rays_.rays.empty()) {
    return {};
  }
  const Box expected = rays_.box.merged(touched_);
  if (std::string reason = whyTooLarge(expected); !reason.empty()) {
    return reason;
  }
  renderer_->render(rays_, cells_);
  Box box = expected;
  for (const SweepTile& tile : cells_.tiles()) {
    for (int y = 0; y < kTileSide; ++y) {
      const std::uint64_t row =
          tile.free[static_cast<std::size_t>(y)] | tile.occupied[static_cast<std::size_t>(y)];
      for (int x = 0; x < kTileSide; ++x) {
        if ((row >> static_cast<unsigned>(x) & 1U) != 0) {
          box.extend(Cell(cornerOf(tile.index) + Cell(x, y)));
        }
      }
    }
  }
  growTo(box);
  touched_ = box;
  count();
  return {};
}

std::string OccupancyMapper::whyTooLarge(const Box& box) const {
  const Eigen::Array2d cells = (box.sizes().array() + 1).cast<double>();
  const Eigen::Array2d extent = cells * config_.resolution;
  if (extent.maxCoeff() > config_.max_extent) {
    return fmt::format("the map would span {:.6g} m by {:.6g} m, which is above the limit of {} m",
                       extent.x(), extent.y(), config_.max_extent);
  }
  if (cells.prod() > static_cast<double>(kMaxCells)) {
    return fmt::format("the map would have {:.0f} x {:.0f} cells, which is more than {}", cells.x(),
                       cells.y(), kMaxCells);
  }
  return {};
}

void OccupancyMapper::growTo(const Box& needed) {
  if (stored_.contains(needed)) {
    return;
  }
  // A margin of a quarter on each side makes the copies, over a long drive, cost as much in the sum
  // as the final map. Near the largest map there is no room for one.
  constexpr int kLeastMargin = 64;
  const Cell margin = (needed.sizes().array() / 4 + kLeastMargin).matrix();
  Box grown(needed.min() - margin, needed.max() + margin);
  if (cellCount(grown) > kMaxCells) {
    grown = needed;
  }
  std::vector<CellCounts> counts(cellCount(grown));
  // Only what was touched can be other than zero; it lies within what is needed.
  for (int y = touched_.min().y(); !touched_.isEmpty() && y <= touched_.max().y(); ++y) {
    const auto from = static_cast<std::ptrdiff_t>(indexIn(stored_, {touched_.min().x(), y}));
    const auto to = static_cast<std::ptrdiff_t>(indexIn(grown, {touched_.min().x(), y}));
    std::copy_n(counts_.begin() + from, touched_.sizes().x() + 1, counts.begin() + to);
  }
  counts_ = std::move(counts);
  stored_ = grown;
}

void OccupancyMapper::count() {
  for (const SweepTile& tile : cells_.tiles()) {
    for (int y = 0; y < kTileSide; ++y) {
      const std::uint64_t hits = tile.occupied[static_cast<std::size_t>(y)];
      const std::uint64_t seen = tile.free[static_cast<std::size_t>(y)] | hits;
      for (int x = 0; x < kTileSide; ++x) {
        if ((seen >> static_cast<unsigned>(x) & 1U) == 0) {
          continue;
        }
        CellCounts& counts = counts_[indexIn(stored_, cornerOf(tile.index) + Cell(x, y))];
        if ((hits >> static_cast<unsigned>(x) & 1U) != 0) {
          counts.hit();
        } else {
          counts.miss();
        }
      }
    }
  }
}

std::int8_t OccupancyMapper::verdict(const CellCounts& counts) const {
  const std::uint64_t observations = counts.observations();
  if (observations < static_cast<std::uint64_t>(config_.min_observations)) {
    return grid::kUnknown;
  }
  const double share = static_cast<double>(counts.hits) / static_cast<double>(observations);
  return share >= config_.occupied_threshold ? grid::kOccupied : grid::kFree;
}

grid::OccupancyGrid OccupancyMapper::render() const {
  if (touched_.isEmpty()) {
    grid::OccupancyGrid empty;
    empty.geometry.resolution = config_.resolution;
    return empty;
  }
  const Cell size = touched_.sizes() + Cell::Ones();
  grid::OccupancyGrid map = grid::makeGrid(
      {config_.resolution, touched_.min().cast<double>() * config_.resolution, size.x(), size.y()},
      grid::kUnknown);
  for (int y = 0; y < size.y(); ++y) {
    const std::size_t row = indexIn(stored_, touched_.min() + Cell(0, y));
    for (int x = 0; x < size.x(); ++x) {
      map.at({x, y}) = verdict(counts_[row + static_cast<std::size_t>(x)]);
    }
  }
  return map;
}

void OccupancyMapper::clear() {
  touched_.setEmpty();
  stored_.setEmpty();
  counts_.clear();
  counts_.shrink_to_fit();
}

}  // namespace omega_slam::mapping
