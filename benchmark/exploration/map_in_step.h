#pragma once

#include <optional>
#include <vector>

#include "exploration/localisation.h"
#include "omega_slam/exploration/explorer.h"
#include "omega_slam/mapping/occupancy_mapper.h"

namespace omega_slam::experiments {

/// The map of a pipeline that runs, and what of it is new to an explorer, as map_builder and
/// frontier_explorer have it between them.
class MapInStep {
 public:
  struct Change {
    std::vector<exploration::PlacedSweep> news;  ///< empty: anything may have changed
    std::optional<geometry::MapMotion> motion;   ///< if what was drawn has moved
    bool is_new{false};                          ///< whether there is anything new at all
  };

  explicit MapInStep(const mapping::OccupancyMapperConfig& config) : mapper_(config) {}

  Change update(const Localisation& localisation);
  [[nodiscard]] grid::OccupancyGrid render() { return mapper_.render(); }

 private:
  mapping::OccupancyMapper mapper_;
  std::vector<geometry::Pose2> poses_;  ///< `T_map_base` of each keyframe at the last update
};

}  // namespace omega_slam::experiments
