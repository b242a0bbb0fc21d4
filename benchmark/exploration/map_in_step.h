#pragma once

#include <vector>

#include "omega_slam/exploration/explorer.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::experiments {

/// The map of a pipeline that runs, drawn as map_builder does: new keyframes are added while the
/// poses stand, and all is drawn anew once one has moved by half a cell.
class MapInStep {
 public:
  struct Change {
    std::vector<exploration::PlacedSweep> news;    ///< empty: all was drawn anew
    std::optional<exploration::MapMotion> motion;  ///< if so
    bool is_new{false};                            ///< whether there is anything new at all
  };

  explicit MapInStep(const mapping::OccupancyMapperConfig& config) : mapper_(config) {}

  Change update(const slam::Pipeline& pipeline);
  [[nodiscard]] grid::OccupancyGrid render() { return mapper_.render(); }

 private:
  mapping::OccupancyMapper mapper_;
  std::vector<geometry::Pose2> drawn_;  ///< `T_map_base` of each keyframe in the map
};

}  // namespace omega_slam::experiments
