#include "omega_slam/mapping/map_snapshot.h"

namespace omega_slam::mapping {

grid::GridGeometry geometryOf(double resolution, const CellBox& cells) {
  if (cells.isEmpty()) {
    return {resolution, {0.0, 0.0}, 0, 0};
  }
  const grid::Cell size = cells.sizes() + grid::Cell::Ones();
  return {resolution, cells.min().cast<double>() * resolution, size.x(), size.y()};
}

void renderTile(const CountTile& tile, const TileIndex& index, const CellRules& rules,
                MapLayer layer, const grid::Cell& corner, grid::OccupancyGrid& grid) {
  const grid::Cell offset = cornerOf(index) - corner;
  for (std::size_t y = 0; y < kTileSide; ++y) {
    const int row = offset.y() + static_cast<int>(y);
    if (row < 0 || row >= grid.geometry.height) {
      continue;
    }
    forEachBit(tile.seen[y], [&](std::size_t x) {
      const grid::Cell cell(offset.x() + static_cast<int>(x), row);
      if (cell.x() >= 0 && cell.x() < grid.geometry.width) {
        const CellCounts counts = tile.at(x, y);
        grid.at(cell) =
            layer == MapLayer::kVerdict ? rules.verdict(counts) : rules.percentage(counts);
      }
    });
  }
}

grid::OccupancyGrid render(const MapSnapshot& map, MapLayer layer) {
  const CellBox bounds = boundsOf(map.tiles);
  grid::OccupancyGrid grid = grid::makeGrid(geometryOf(map.resolution, bounds), grid::kUnknown);
  map.tiles.forEach([&](const TileIndex& index, const auto& tile) {
    if (tile) {
      renderTile(*tile, index, map.rules, layer, bounds.min(), grid);
    }
  });
  return grid;
}

}  // namespace omega_slam::mapping
