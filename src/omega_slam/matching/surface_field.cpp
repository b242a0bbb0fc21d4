#include "omega_slam/matching/surface_field.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace omega_slam::matching {

namespace {

constexpr double kCellsPerReach = 2.5;
constexpr double kLeastAgreement = 0.5;  // of two normals: within 60 degrees

}  // namespace

SurfaceField::SurfaceField(TracedSurfaces surfaces, double reach)
    : surfaces_(std::move(surfaces)),
      reach_(reach),
      side_(reach / kCellsPerReach),
      radius_(reach + std::sqrt(0.5) * side_) {
  Eigen::AlignedBox2d box;
  for (const SurfaceSample& sample : surfaces_.samples) {
    box.extend(sample.place);
  }
  if (box.isEmpty()) {
    return;
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius_);
  nearest_ = {cellOf(box.min() - margin), cellOf(box.max() + margin)};
  for (std::size_t i = 0; i < surfaces_.samples.size(); ++i) {
    paint(i);
  }
}

std::optional<SurfaceModel::Partner> SurfaceField::partnerOf(const Eigen::Vector2d& p_reference,
                                                             const Eigen::Vector2d& facing) const {
  const grid::Cell cell = cellOf(p_reference);
  const std::uint32_t nearest = nearest_.at(cell.x(), cell.y()).sample;
  if (nearest == 0) {
    return std::nullopt;
  }
  const SurfaceSample& sample = surfaces_.samples[nearest - 1];
  const SurfacePatch& patch = surfaces_.patches[sample.patch];
  const Surface& surface = patch.surface;
  if ((p_reference - sample.place).squaredNorm() > reach_ * reach_) {
    return std::nullopt;
  }
  if (surface.isLine() && !facing.isZero() && surface.normal.dot(facing) < kLeastAgreement) {
    return std::nullopt;
  }
  return SurfaceModel::Partner{surface.isLine() ? patch.point : sample.place, surface};
}

grid::Cell SurfaceField::cellOf(const Eigen::Vector2d& place) const {
  return (place / side_).array().floor().cast<int>();
}

void SurfaceField::paint(std::size_t sample) {
  const Eigen::Vector2d& place = surfaces_.samples[sample].place;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius_);
  const grid::Cell min = cellOf(place - margin);
  const grid::Cell max = cellOf(place + margin);
  for (int y = min.y(); y <= max.y(); ++y) {
    const double dy = (y + 0.5) * side_ - place.y();
    nearest_.visitRow(min.x(), max.x(), y, [&](int first, Nearest* cells, int count) {
      for (int i = 0; i < count; ++i) {
        const double dx = (first + i + 0.5) * side_ - place.x();
        const auto squared = static_cast<float>(dx * dx + dy * dy);
        if (cells[i].sample == 0 || squared < cells[i].squared_distance) {
          cells[i] = {static_cast<std::uint32_t>(sample + 1), squared};
        }
      }
    });
  }
}

}  // namespace omega_slam::matching
