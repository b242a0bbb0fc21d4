#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/matching/blocked_cells.h"
#include "omega_slam/matching/scan_matcher.h"
#include "omega_slam/matching/window_cells.h"

namespace omega_slam::matching {

struct LocalMapConfig {
  double resolution{0.025};  ///< [m] edge of a cell of the finest grid
  int levels{4};             ///< grids; each has cells twice as wide as the one before
  double reach{20.0};        ///< [m] returns farther from the laser are left out

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// How likely places are to be occupied: one resolution of a LocalMap. Row-major.
struct ValueGrid {
  static constexpr double kMost = 255.0;  ///< certainly occupied

  grid::GridGeometry geometry;
  ZeroedCells<std::uint8_t> values;  ///< 0 where free or unknown; so are the border cells
};

/// What the views of a laser say of the robot's surroundings: occupancy at several resolutions
/// (Kohlbrecher et al. 2011, "A flexible and scalable SLAM system with full 3D motion estimation",
/// SSRR, section IV).
///
/// The cell in which a beam ends becomes more likely to be occupied, cells on its way less (log
/// odds are added, up to a limit, so that what has changed is believed after some views); a view
/// counts once in a cell, and an end wins.
///
/// Deviations from the paper:
/// - A cell's value is p - (1 - p), not below zero, where the paper has p. Free and unknown are
///   worth the same, so that a wall that was seen from one side does not lean to the other.
/// - Between neighbouring returns close together the wall is drawn through: else walls that are
///   seen from afar would be dotted, and the next scan's points be drawn to the dots.
/// - Beams are traced through the finest grid only; a coarser cell is worth as much as the most
///   likely of the four that it covers. Of beams that end close together one is traced.
/// - The map grows with what is seen, and what the robot has left behind by more than twice the
///   reach is forgotten: memory is bounded by (4 * reach / resolution)^2 cells.
///
/// Deterministic; not thread-safe while a view is put in.
class LocalMap {
 public:
  static constexpr std::size_t kRecentViews = 20;

  explicit LocalMap(const LocalMapConfig& config = {});  ///< @throws std::invalid_argument

  /// A map of some views, with room for these alone.
  /// @param views in the map's frame
  LocalMap(const LocalMapConfig& config, const Reference& views);

  /// Puts a view in. Points that are out of reach or not finite are left out. O(length of the beams
  /// / resolution), and O(cells) now and then, when the view does not fit into the window.
  /// @param T_map_view pose in the map of the frame that the view is in
  /// @return whether it could be done: the laser's place must be finite, and no farther than
  /// 1000 km from the map's origin
  bool insert(const View& view, const geometry::Pose2& T_map_view);

  /// Forgets everything and draws some views: as a map of these alone, but with room to grow, and
  /// in the memory that it has.
  /// @param views in the map's frame
  void redraw(const Reference& views);

  void clear();  ///< forgets everything

  [[nodiscard]] const LocalMapConfig& config() const { return config_; }

  /// What was put in last, kRecentViews at most, in the map's frame, the newest last: for matchers
  /// that want to see views.
  [[nodiscard]] const Reference& recentViews() const { return recent_views_; }

  /// Whether a place was seen to be free, and nothing to be near it: no cell of the coarsest grid's
  /// that it lies in or that it lies next to is occupied. Any place may be asked for.
  [[nodiscard]] bool isFreeAround(const Eigen::Vector2d& p_map) const;

  /// As many as config().levels, the finest first. Without cells as long as there are no views.
  [[nodiscard]] const std::vector<ValueGrid>& grids() const { return grids_; }

 private:
  struct Evidence {
    std::int8_t odds;    ///< log odds of being occupied
    std::uint8_t claim;  ///< number of the view that changed the cell last
  };
  using Box = Eigen::AlignedBox2d;

  [[nodiscard]] std::optional<View> inReach(const View& view_map) const;
  [[nodiscard]] Reference inReach(const Reference& views_map) const;
  void makeRoomFor(const Box& box, const Eigen::Vector2d& center);
  void moveWindow(const Box& wanted, const Eigen::Vector2d& center);
  void wipe();
  [[nodiscard]] int splitAt(std::size_t level) const;
  void put(View view);
  void draw(const View& view);
  void noteDrawn(const Box& box);
  void numberView();
  [[nodiscard]] Eigen::Vector2d inCells(const Eigen::Vector2d& p_map) const;
  void drawWalls(const Points& points);
  void drawBeams(const View& view);
  void drawWall(const Eigen::Vector2d& start, const Eigen::Vector2d& end);
  void drawBeam(const Eigen::Vector2d& laser, const Eigen::Vector2d& end);
  void refresh(const grid::Cell& cell, int odds);

  LocalMapConfig config_;
  std::array<std::uint8_t, 64> values_by_odds_{};
  /// Of a cell that a beam passes, by its odds as a byte: where the view has been in the cell
  /// before, and, from 256 on, where it has not.
  std::array<std::int8_t, 512> odds_after_{};
  Reference recent_views_;
  std::vector<ValueGrid> grids_;
  BlockedCells<Evidence> evidence_;  ///< of the finest grid; a block is a cell of the coarsest
  Box drawable_;                     ///< [m] the window: what lies outside is not drawn
  CellBox drawn_;                    ///< of the coarsest grid: elsewhere, all grids are zero
  std::uint8_t number_{0};           ///< of the newest view
};

}  // namespace omega_slam::matching
