#include "omega_slam/simulation/world.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace omega_slam::simulation {
namespace {

/// One axis of the grid traversal: which cell the ray is in, and how far off the next border is.
struct AxisWalk {
  int cell;
  int direction;       ///< +1, -1, or 0 where the ray runs along the border
  double next_border;  ///< length of the ray at the next border; infinite if there is none
  double per_cell;     ///< length of the ray between two borders

  /// @param position, heading of the ray, both in cells
  AxisWalk(double position, double heading)
      : cell(static_cast<int>(std::floor(position))),
        direction(heading > 0.0 ? 1 : (heading < 0.0 ? -1 : 0)),
        next_border(std::numeric_limits<double>::infinity()),
        per_cell(std::numeric_limits<double>::infinity()) {
    if (direction != 0) {
      const double border = direction > 0 ? cell + 1.0 : static_cast<double>(cell);
      next_border = (border - position) / heading;
      per_cell = std::abs(1.0 / heading);
    }
  }

  /// Crosses the next border; @return the ray's length there
  double advance() {
    const double crossed = next_border;
    cell += direction;
    next_border += per_cell;
    return crossed;
  }
};

bool stopsLight(Material material) {
  return material == Material::kWall || material == Material::kDark;
}

Material materialOf(std::uint8_t pixel, const grid::MapImage& image) {
  const std::uint8_t grey = image.negate ? static_cast<std::uint8_t>(255 - pixel) : pixel;
  if ((255 - grey) / 255.0 <= image.occupied_threshold) {
    return Material::kNone;
  }
  if (grey == kDarkGrey) {
    return Material::kDark;
  }
  return grey == kGlassGrey ? Material::kGlass : Material::kWall;
}

}  // namespace

World::World(const grid::GridGeometry& geometry, std::vector<Material> cells)
    : geometry_(geometry), cells_(std::move(cells)) {
  if (geometry_.width <= 0 || geometry_.height <= 0 || !(geometry_.resolution > 0.0)) {
    throw std::invalid_argument("A world needs cells: width, height and resolution above 0.");
  }
  if (cells_.size() != geometry_.size()) {
    throw std::invalid_argument("A world needs one material for each cell.");
  }
}

World World::fromImage(const grid::MapImage& image) {
  if (image.mode == grid::MapMode::kRaw) {
    throw std::invalid_argument(
        "A world can't be made of a map whose mode is raw: greys name the materials.");
  }
  std::vector<Material> cells;
  cells.reserve(image.pixels.size());
  for (const std::uint8_t pixel : image.pixels) {
    cells.push_back(materialOf(pixel, image));
  }
  return World(image.geometry, std::move(cells));
}

Material World::at(const grid::Cell& cell) const {
  return geometry_.contains(cell) ? cells_[geometry_.index(cell)] : Material::kNone;
}

bool World::isSolid(const grid::Cell& cell) const {
  return !geometry_.contains(cell) || cells_[geometry_.index(cell)] != Material::kNone;
}

std::optional<RayHit> World::castRay(const Eigen::Vector2d& origin, double angle,
                                     double max_range) const {
  const Eigen::Vector2d start = (origin - geometry_.origin) / geometry_.resolution;
  AxisWalk x(start.x(), std::cos(angle));
  AxisWalk y(start.y(), std::sin(angle));
  const double max_length = max_range / geometry_.resolution;
  double length = 0.0;
  while (length <= max_length) {
    const Material material = at({x.cell, y.cell});
    if (stopsLight(material)) {
      return RayHit{length * geometry_.resolution, material};
    }
    length = x.next_border < y.next_border ? x.advance() : y.advance();
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> World::nearestObstacle(const Eigen::Vector2d& center,
                                                      double radius) const {
  const Eigen::Vector2d in_cells = (center - geometry_.origin) / geometry_.resolution;
  if (!(in_cells.array() >= 0.0).all() || !(in_cells.x() < geometry_.width) ||
      !(in_cells.y() < geometry_.height)) {
    return center;  // outside of the image, however far
  }
  const Eigen::Vector2d reach(radius, radius);
  const grid::Cell low = geometry_.cellAt(center - reach);
  const grid::Cell high = geometry_.cellAt(center + reach);
  std::optional<Eigen::Vector2d> nearest;
  double nearest_distance = radius;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const grid::Cell cell(column, row);
      if (!isSolid(cell)) {
        continue;
      }
      const Eigen::Vector2d corner = geometry_.origin + geometry_.resolution * cell.cast<double>();
      const Eigen::Vector2d edge(geometry_.resolution, geometry_.resolution);
      const Eigen::Vector2d point = center.cwiseMax(corner).cwiseMin(corner + edge);
      const double distance = (point - center).norm();
      if (distance < nearest_distance) {
        nearest_distance = distance;
        nearest = point;
      }
    }
  }
  return nearest;
}

}  // namespace omega_slam::simulation
