#include "omega_slam/mapping/occupancy_mapper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace omega_slam::mapping {
namespace {

void append(std::vector<std::string>& faults, const std::vector<std::string>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

std::string whyTooLarge(const CellBox& box, const OccupancyMapperConfig& config) {
  if (box.isEmpty()) {
    return {};
  }
  const Eigen::Array2d cells = (box.max().cast<double>() - box.min().cast<double>()).array() + 1.0;
  const Eigen::Array2d extent = cells * config.resolution;
  if (extent.maxCoeff() > config.max_extent) {
    return fmt::format("the map would span {:.6g} m by {:.6g} m, which is above the limit of {} m",
                       extent.x(), extent.y(), config.max_extent);
  }
  if (cells.prod() > static_cast<double>(OccupancyMapper::kMaxCells)) {
    return fmt::format("the map would have {:.0f} x {:.0f} cells, which is more than {}", cells.x(),
                       cells.y(), OccupancyMapper::kMaxCells);
  }
  return {};
}

}  // namespace

std::vector<std::string> OccupancyMapperConfig::validate() const {
  std::vector<std::string> faults;
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    faults.push_back(fmt::format("resolution must be above 0 m, but it is {}.", resolution));
  }
  if (!std::isfinite(max_range) || max_range < 0.0) {
    faults.push_back(
        fmt::format("max_range must be 0 (no limit) or above, but it is {}.", max_range));
  }
  if (!std::isfinite(max_extent) || max_extent <= 0.0) {
    faults.push_back(fmt::format("max_extent must be above 0 m, but it is {}.", max_extent));
  }
  append(faults, renderer.validate());
  append(faults, rules.validate());
  return faults;
}

OccupancyMapper::OccupancyMapper(const OccupancyMapperConfig& config) : config_(config) {
  const std::vector<std::string> faults = config.validate();
  if (!faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  renderer_ = makeRenderer(config.renderer);
}

std::string OccupancyMapper::put(const PlacedSweep& placed) {
  const auto place = find(placed.id);
  const bool is_in = place != drawn_.end() && place->placed.id == placed.id;
  if (is_in) {
    subtract(place->placed);
  }
  std::string reason = draw(placed);
  if (reason.empty()) {
    reason = whyTooLarge(rays_.box);
  }
  if (!reason.empty()) {
    if (is_in) {
      drawn_.erase(place);
    }
    return reason;
  }
  bounds_.extend(rays_.box);
  counts_.add(cells_);
  if (config_.forget_people) {
    people_.add(placed.id, rays_, cells_);
  }
  const DrawnSweep drawn{placed, reachFrom(placed.T_map_base)};
  if (is_in) {
    *place = drawn;
  } else {
    drawn_.insert(place, drawn);
  }
  return {};
}

std::string OccupancyMapper::add(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base) {
  const SweepId id = drawn_.empty() ? 0 : drawn_.back().placed.id + 1;
  return put({id, std::make_shared<const sensing::Sweep>(sweep), T_map_base});
}

void OccupancyMapper::takeOut(SweepId id) {
  const auto place = find(id);
  if (place != drawn_.end() && place->placed.id == id) {
    subtract(place->placed);
    drawn_.erase(place);
  }
}

/// Where the sweep of that number is, or would be.
std::vector<DrawnSweep>::iterator OccupancyMapper::find(SweepId id) {
  return std::lower_bound(
      drawn_.begin(), drawn_.end(), id,
      [](const DrawnSweep& drawn, SweepId number) { return drawn.placed.id < number; });
}

void OccupancyMapper::subtract(const PlacedSweep& placed) {
  // The same sweep at the same pose is drawn to the same cells: it was not refused then.
  static_cast<void>(draw(placed));
  counts_.subtract(cells_);
  if (config_.forget_people) {
    people_.remove(placed.id, cells_);
  }
}

/// Marks cells_. @return an empty string, or why the sweep can't be drawn
std::string OccupancyMapper::draw(const PlacedSweep& placed) {
  std::string reason =
      placeRays(*placed.sweep, placed.T_map_base, config_.resolution, config_.max_range, rays_);
  if (reason.empty()) {
    reason = mapping::whyTooLarge(rays_.box, config_);
  }
  if (reason.empty()) {
    renderer_->render(rays_, cells_);
  }
  return reason;
}

/// [m] from the base to the farthest end of rays_.
double OccupancyMapper::reachFrom(const geometry::Pose2& T_map_base) const {
  const Eigen::Vector2d base = T_map_base.translation() / config_.resolution;
  double reach = 0.0;
  for (const Ray& ray : rays_.rays) {
    reach = std::max(reach, (ray.end - base).norm());
  }
  return reach * config_.resolution;
}

/// Whether the map with one more sweep is too large.
std::string OccupancyMapper::whyTooLarge(const CellBox& sweep) {
  const std::string reason = mapping::whyTooLarge(bounds_.merged(sweep), config_);
  if (reason.empty()) {
    return {};
  }
  // Perhaps what made it so large has been taken out since.
  bounds_ = boundsOf(counts_.snapshot());
  return mapping::whyTooLarge(bounds_.merged(sweep), config_);
}

MapSnapshot OccupancyMapper::snapshot() {
  people_.settle(counts_);
  return {config_.resolution, config_.rules, counts_.snapshot()};
}

grid::OccupancyGrid OccupancyMapper::render() {
  return mapping::render(snapshot(), MapLayer::kVerdict);
}

void OccupancyMapper::clear() {
  drawn_.clear();
  counts_.clear();
  people_.clear();
  bounds_.setEmpty();
}

}  // namespace omega_slam::mapping
