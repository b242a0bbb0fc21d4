#pragma once

#include "omega_slam/mapping/map_snapshot.h"

namespace omega_slam::mapping {

/// Cells of a raster, by column and row: both corners are inclusive; empty: none.
struct RasterChange {
  bool is_resized{false};  ///< the grid lies elsewhere now, or has another size: all is new
  CellBox cells;           ///< what may differ from before, counted from the grid's first cell
};

/// Keeps a whole grid in step with a map, as it is published: with each snapshot only the tiles
/// that have changed are rendered again. The grid covers whole tiles, so that it seldom changes its
/// size. Not thread-safe; it needs no access to the mapper.
class MapRaster {
 public:
  explicit MapRaster(MapLayer layer) : layer_(layer) {}

  /// Shows another snapshot of the same map.
  RasterChange update(const MapSnapshot& map);

  [[nodiscard]] const grid::OccupancyGrid& grid() const { return grid_; }
  [[nodiscard]] MapLayer layer() const { return layer_; }

 private:
  void resize(double resolution, const CellBox& tiles);
  [[nodiscard]] CellBox renderAgain(const MapSnapshot& map, const TileIndex& index);

  MapLayer layer_;
  CountTiles shown_;  ///< the tiles that the grid shows; held so that none is mistaken for another
  CellBox tiles_;     ///< that the grid covers
  grid::OccupancyGrid grid_;
};

}  // namespace omega_slam::mapping
