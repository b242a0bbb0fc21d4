#include "support/drawn_world.h"

#include <cmath>
#include <utility>

namespace omega_slam::test {

using simulation::Material;

std::shared_ptr<const simulation::World> drawnWorld(const std::vector<std::string>& rows,
                                                    double resolution) {
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = static_cast<int>(rows.front().size());
  geometry.height = static_cast<int>(rows.size());
  std::vector<Material> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char symbol : *row) {
      cells.push_back(symbol == '#'   ? Material::kWall
                      : symbol == 'd' ? Material::kDark
                      : symbol == 'g' ? Material::kGlass
                                      : Material::kNone);
    }
  }
  return std::make_shared<simulation::World>(geometry, std::move(cells));
}

std::shared_ptr<const simulation::World> emptyRoom(double half, double resolution) {
  grid::GridGeometry geometry;
  geometry.resolution = resolution;
  const int inside = 2 * static_cast<int>(std::lround(half / resolution));
  geometry.width = geometry.height = inside + 2;
  geometry.origin.setConstant(-half - resolution);
  std::vector<Material> cells(geometry.size(), Material::kNone);
  for (int i = 0; i < geometry.width; ++i) {
    for (const grid::Cell& cell : {grid::Cell(i, 0), grid::Cell(i, geometry.height - 1),
                                   grid::Cell(0, i), grid::Cell(geometry.width - 1, i)}) {
      cells[geometry.index(cell)] = Material::kWall;
    }
  }
  return std::make_shared<simulation::World>(geometry, std::move(cells));
}

}  // namespace omega_slam::test
