#pragma once

#include <cstdint>

#include "omega_slam/grid/occupancy_grid.h"
#include "omega_slam/mapping/count_map.h"

namespace omega_slam::mapping {

/// A map at one moment. It never changes and costs little to make, to copy and to keep: threads
/// that publish or save take one, and leave the mapper alone.
struct MapSnapshot {
  double resolution{0.05};  ///< [m]
  CellRules rules;
  CountTiles tiles;
};

/// What is shown of the counts.
enum class MapLayer : std::uint8_t {
  kVerdict = 0,     ///< -1, 0 or 100
  kProbability = 1  ///< -1, or 0..100: the probability of a wall in percent
};

/// The map, cropped to the cells that were seen; an empty grid (0 x 0) if there are none.
[[nodiscard]] grid::OccupancyGrid render(const MapSnapshot& map, MapLayer layer);

/// Where a grid over a box of cells lies in the map.
[[nodiscard]] grid::GridGeometry geometryOf(double resolution, const CellBox& cells);

/// Writes what a snapshot shows of one tile into a grid that begins at cell `corner` of the map;
/// cells outside of the grid are left out.
void renderTile(const CountTile& tile, const TileIndex& index, const CellRules& rules,
                MapLayer layer, const grid::Cell& corner, grid::OccupancyGrid& grid);

}  // namespace omega_slam::mapping
