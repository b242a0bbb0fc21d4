#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/grid/map_file.h"

namespace omega_slam::simulation {

/// What a cell of the world is made of. All but kNone stop the robot.
enum class Material : std::uint8_t {
  kNone = 0,
  kWall = 1,  ///< the laser sees it
  kDark = 2,  ///< the laser sees it from near only
  kGlass = 3  ///< the laser looks through it
};

/// Grey values that mark a material in an image whose other occupied pixels are walls. All of them
/// are dark enough to be obstacles for whoever reads the image as a plain map_server map.
inline constexpr std::uint8_t kDarkGrey = 32;
inline constexpr std::uint8_t kGlassGrey = 64;

struct RayHit {
  double range{0.0};  ///< [m] from the ray's origin to where it enters the cell
  Material material{Material::kNone};
};

/// The place that the robot drives in: square cells of materials, in the frame of the map image.
/// Immutable, so any number of threads may look at it.
///
/// Outside of the image there is nothing to see, and nowhere to go: rays pass, the robot does not.
class World {
 public:
  /// @param cells row-major, row 0 at the bottom
  /// @throws std::invalid_argument if the geometry is empty or the cells do not fill it
  World(const grid::GridGeometry& geometry, std::vector<Material> cells);

  /// Reads materials from grey values. Unknown (grey) and free pixels are both empty.
  /// @throws std::invalid_argument if the image is empty or its mode is raw
  [[nodiscard]] static World fromImage(const grid::MapImage& image);

  [[nodiscard]] const grid::GridGeometry& geometry() const { return geometry_; }

  /// kNone outside of the image.
  [[nodiscard]] Material at(const grid::Cell& cell) const;

  /// The first cell on a ray that stops light (glass does not), by exact traversal of the grid
  /// (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing"). Linear in the
  /// cells passed. An origin inside of such a cell gives range 0.
  /// @param origin [m], in the world; finite
  /// @param angle [rad], in the world
  /// @param max_range [m], finite
  [[nodiscard]] std::optional<RayHit> castRay(const Eigen::Vector2d& origin, double angle,
                                              double max_range) const;

  /// The point of an obstacle that lies nearest to a point, if one is nearer than `radius`.
  /// Everything outside of the image counts as an obstacle.
  /// @param center [m], in the world; @param radius [m]; @return [m], in the world
  [[nodiscard]] std::optional<Eigen::Vector2d> nearestObstacle(const Eigen::Vector2d& center,
                                                               double radius) const;

 private:
  [[nodiscard]] bool isSolid(const grid::Cell& cell) const;

  grid::GridGeometry geometry_;
  std::vector<Material> cells_;
};

}  // namespace omega_slam::simulation
