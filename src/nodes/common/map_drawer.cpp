#include "nodes/common/map_drawer.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam {
namespace {

constexpr double kCellShare = 0.5;  // of a cell, that the end of a beam may be off

double reachOf(const sensing::Sweep& sweep) {
  double reach = 0.0;
  for (const sensing::Beam& beam : sweep.beams) {
    if (beam.kind != sensing::BeamKind::kUnknown) {
      reach = std::max(reach, beam.end.norm());
    }
  }
  return reach;
}

}  // namespace

MapDrawer::MapDrawer(const mapping::OccupancyMapperConfig& config)
    : tolerance_(kCellShare * config.resolution), mapper_(config) {}

DrawReport MapDrawer::update(const std::vector<PlacedKeyframe>& keyframes) {
  DrawReport report;
  if (!allStand(keyframes)) {
    clear();
    report.is_redrawn = true;
  }
  for (const PlacedKeyframe& placed : keyframes) {
    const slam::Keyframe& keyframe = *placed.keyframe;
    if (drawn_.count(keyframe.id) > 0) {
      continue;
    }
    if (std::string refusal = mapper_.add(keyframe.sweep, placed.T_map_base); !refusal.empty()) {
      report.refusals.push_back(std::move(refusal));
      continue;
    }
    drawn_[keyframe.id] = {placed.keyframe, placed.T_map_base, reachOf(keyframe.sweep)};
    ++report.drawn;
  }
  return report;
}

bool MapDrawer::allStand(const std::vector<PlacedKeyframe>& keyframes) const {
  std::size_t standing = 0;
  for (const PlacedKeyframe& placed : keyframes) {
    const auto drawn = drawn_.find(placed.keyframe->id);
    if (drawn == drawn_.end()) {
      continue;
    }
    if (!stands(drawn->second, placed)) {
      return false;
    }
    ++standing;
  }
  return standing == drawn_.size();
}

bool MapDrawer::stands(const Drawn& drawn, const PlacedKeyframe& now) const {
  const double turn =
      std::abs(geometry::angleDifference(now.T_map_base.theta, drawn.T_map_base.theta));
  return drawn.keyframe == now.keyframe &&
         geometry::distance(drawn.T_map_base, now.T_map_base) + turn * drawn.reach <= tolerance_;
}

void MapDrawer::clear() {
  mapper_.clear();
  drawn_.clear();
}

}  // namespace omega_slam
