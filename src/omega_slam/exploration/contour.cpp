#include "omega_slam/exploration/contour.h"

#include "omega_slam/grid/ray_traversal.h"

namespace omega_slam::exploration {
namespace {

/// [cells] Corners of the outline; first and last are the laser.
std::vector<Eigen::Vector2d> outlineOf(const sensing::Sweep& sweep,
                                       const geometry::Pose2& T_map_base, const MapView& map) {
  const double resolution = map.geometry().resolution;
  const Eigen::Vector2d origin = map.center({0, 0}) - Eigen::Vector2d::Constant(0.5 * resolution);
  const auto corner = [&](const Eigen::Vector2d& p_base) {
    return Eigen::Vector2d((T_map_base * p_base - origin) / resolution);
  };
  const Eigen::Vector2d laser = corner(sweep.T_base_laser.translation());
  std::vector<Eigen::Vector2d> outline{laser};
  bool at_laser = true;
  for (const sensing::Beam& beam : sweep.beams) {
    if (beam.kind != sensing::BeamKind::kUnknown) {
      outline.push_back(corner(beam.end));
      at_laser = false;
    } else if (!at_laser) {
      outline.push_back(laser);
      at_laser = true;
    }
  }
  if (!at_laser) {
    outline.push_back(laser);
  }
  return outline;
}

Eigen::AlignedBox2i boxAround(const std::vector<Eigen::Vector2d>& outline, int margin) {
  Eigen::AlignedBox2i box;
  for (const Eigen::Vector2d& corner : outline) {
    box.extend(Cell(corner.array().floor().cast<int>().matrix()));
  }
  return {box.min() - Cell(margin, margin), box.max() + Cell(margin, margin)};
}

}  // namespace

Contour contourOf(const sensing::Sweep& sweep, const geometry::Pose2& T_map_base,
                  const MapView& map, int margin) {
  Contour contour;
  if (!T_map_base.isFinite()) {
    return contour;
  }
  const std::vector<Eigen::Vector2d> outline = outlineOf(sweep, T_map_base, map);
  if (outline.size() < 2) {
    return contour;
  }
  contour.touched = boxAround(outline, margin);
  const Cell extent = contour.touched.sizes() + Cell(1, 1);
  std::vector<bool> met(static_cast<std::size_t>(extent.x()) *
                        static_cast<std::size_t>(extent.y()));
  const auto meet = [&](const Cell& center) {
    for (int y = -margin; y <= margin; ++y) {
      for (int x = -margin; x <= margin; ++x) {
        const Cell cell = center + Cell(x, y);
        const Cell local = cell - contour.touched.min();
        const auto index =
            static_cast<std::size_t>(local.y()) * static_cast<std::size_t>(extent.x()) +
            static_cast<std::size_t>(local.x());
        if (!met[index]) {
          met[index] = true;
          contour.cells.push_back(cell);
        }
      }
    }
  };
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    grid::traverseCells(outline[i], outline[i + 1], meet);
  }
  return contour;
}

}  // namespace omega_slam::exploration
