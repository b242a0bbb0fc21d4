#include "omega_slam/mapping/map_raster.h"

#include <algorithm>

namespace omega_slam::mapping {
namespace {

CellBox boxOfTiles(const CountTiles& tiles) {
  CellBox box;
  tiles.forEach([&box](const TileIndex& index, const auto& tile) {
    if (tile) {
      box.extend(index);
    }
  });
  return box;
}

CellBox cellsOf(const CellBox& tiles) {
  return tiles.isEmpty() ? CellBox()
                         : CellBox(cornerOf(tiles.min()),
                                   cornerOf(tiles.max() + TileIndex::Ones()) - grid::Cell::Ones());
}

}  // namespace

RasterChange MapRaster::update(const MapSnapshot& map) {
  const CellBox tiles = boxOfTiles(map.tiles);
  RasterChange change;
  change.is_resized = tiles.isEmpty() != tiles_.isEmpty() ||
                      (!tiles.isEmpty() && !tiles.isApprox(tiles_)) ||
                      grid_.geometry.resolution != map.resolution;
  if (change.is_resized) {
    resize(map.resolution, tiles);
  }
  for (int y = tiles_.min().y(); !tiles_.isEmpty() && y <= tiles_.max().y(); ++y) {
    for (int x = tiles_.min().x(); x <= tiles_.max().x(); ++x) {
      if (map.tiles.at({x, y}) != shown_.at({x, y})) {
        change.cells.extend(renderAgain(map, {x, y}));
      }
    }
  }
  shown_ = map.tiles;
  return change;
}

/// @return the tile's cells, counted from the grid's first
CellBox MapRaster::renderAgain(const MapSnapshot& map, const TileIndex& index) {
  const grid::Cell corner = cornerOf(tiles_.min());
  const grid::Cell first = cornerOf(index) - corner;
  for (int y = first.y(); y < first.y() + kTileSide; ++y) {
    std::fill_n(&grid_.at({first.x(), y}), kTileSide, grid::kUnknown);
  }
  if (const auto& tile = map.tiles.at(index)) {
    renderTile(*tile, index, map.rules, layer_, corner, grid_);
  }
  return {first, grid::Cell(first.array() + (kTileSide - 1))};
}

/// Lays the grid out anew; tiles that stay are copied, not rendered.
void MapRaster::resize(double resolution, const CellBox& tiles) {
  const CellBox before = cellsOf(tiles_);
  const CellBox now = cellsOf(tiles);
  grid::OccupancyGrid resized = grid::makeGrid(geometryOf(resolution, now), grid::kUnknown);
  const CellBox common = before.intersection(now);
  for (int y = common.min().y(); !common.isEmpty() && y <= common.max().y(); ++y) {
    const grid::Cell first(common.min().x(), y);
    std::copy_n(&grid_.at(first - before.min()), common.sizes().x() + 1,
                &resized.at(first - now.min()));
  }
  grid_ = std::move(resized);
  tiles_ = tiles;
}

}  // namespace omega_slam::mapping
