#pragma once

#include <map>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam {

/// A keyframe where the graph now believes it.
struct PlacedKeyframe {
  slam::KeyframePtr keyframe;
  geometry::Pose2 T_map_base;
};

/// What one update has done.
struct DrawReport {
  std::size_t drawn{0};               ///< keyframes drawn just now
  bool is_redrawn{false};             ///< whether all was drawn again
  std::vector<std::string> refusals;  ///< why keyframes could not be drawn, once for each
};

/// Keeps an occupancy map in step with the graph at the least expense: while poses stand, only new
/// keyframes are drawn; once one has moved so far that its farthest beam ends half a cell from
/// where it did, or is gone, all are drawn again. Not thread-safe.
class MapDrawer {
 public:
  explicit MapDrawer(const mapping::OccupancyMapperConfig& config);  ///< @throws
                                                                     ///< std::invalid_argument

  DrawReport update(const std::vector<PlacedKeyframe>& keyframes);

  [[nodiscard]] grid::OccupancyGrid render() const { return mapper_.render(); }
  [[nodiscard]] std::size_t drawn() const { return drawn_.size(); }  ///< keyframes in the map
  void clear();

 private:
  struct Drawn {
    slam::KeyframePtr keyframe;
    geometry::Pose2 T_map_base;
    double reach{0.0};  ///< [m] from the base to its farthest beam's end
  };
  [[nodiscard]] bool stands(const Drawn& drawn, const PlacedKeyframe& now) const;
  [[nodiscard]] bool allStand(const std::vector<PlacedKeyframe>& keyframes) const;

  double tolerance_;  ///< [m] that the end of a beam may be off
  mapping::OccupancyMapper mapper_;
  std::map<graph::NodeId, Drawn> drawn_;
};

}  // namespace omega_slam
