#pragma once

#include <cstddef>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/grid_geometry.h"
#include "omega_slam/matching/likelihood_pyramid.h"
#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// A neighbourhood of poses.
struct SearchWindow {
  double translation{1.0};  ///< [m] to each side along x and y
  double rotation{0.3};     ///< [rad] to each side
};

struct CorrelativeSearchConfig {
  SearchWindow window;      ///< around the guess
  double resolution{0.02};  ///< [m] between the poses that are tried
  double reach{0.1};        ///< [m] a point farther from all surfaces adds nothing
  double least_score{0.0};  ///< [0, 1] poses that score less are of no use, and found sooner
  double least_rival{0.0};  ///< [0, 1] likewise after the best one, of its score
};

/// The poses that a search tries: a guess and those around it, in even steps along the reference's
/// axes and in heading. Indices count from the window's corner.
struct PoseLattice {
  geometry::Pose2 center;  ///< the guess
  double step{0.0};        ///< [m]
  double turn{0.0};        ///< [rad]
  int steps{0};            ///< to each side
  int turns{0};            ///< to each side

  [[nodiscard]] geometry::Pose2 poseAt(int x, int y, int a) const;
};

/// Neighbouring poses of a lattice: 2^level of them from each index on.
struct PoseBlock {
  int level{0};
  int x{0};
  int y{0};
  int a{0};
};

/// A pose that suits better than those around it.
struct CorrelativePeak {
  geometry::Pose2 T_reference_scan;
  double score{0.0};  ///< [0, 1] mean likelihood of the scan's points there (LikelihoodPyramid)
};

/// Finds the poses at which a scan lies best on the surfaces of a reference, wherever in a window
/// they are: the correlative search of Olson 2009 ("Real-time correlative scan matching", ICRA) by
/// branch and bound, as in Hess et al. 2016 ("Real-time loop closure in 2D lidar SLAM", ICRA); but
/// here best first, and with blocks of headings as well as of places. The best pose is the one that
/// trying all of them would find.
///
/// A turn of the lattice moves the scan's farthest point by one step (Olson, section III). A pose
/// away from the guess must score a little more, 0.02 at the window's edge, so that a corridor, in
/// which all are equal, does not lead astray.
///
/// Everything must lie within a few hundred metres of the frame's origin. Immutable.
class CorrelativeSearch {
 public:
  /// @param surfaces places on surfaces of the reference [m]
  /// @param guess    `T_reference_scan`
  CorrelativeSearch(const Points& surfaces, const Points& scan, const geometry::Pose2& guess,
                    const CorrelativeSearchConfig& config);

  /// The best pose, and those that are best away from the better ones; none without any overlap.
  /// @param count at most so many
  /// @param apart poses of which place or heading differ by no more are one peak
  [[nodiscard]] std::vector<CorrelativePeak> peaks(std::size_t count,
                                                   const SearchWindow& apart = {0.5, 0.35}) const;

  /// Mean likelihood [0, 1] of the scan's points at any pose.
  [[nodiscard]] double score(const geometry::Pose2& T_reference_scan) const;

  /// What no pose of a block scores more than, in kFull-ths of a point, less what it must score
  /// more for being away from the guess. The score itself where the block is one pose.
  [[nodiscard]] int bound(const PoseBlock& block) const;

  [[nodiscard]] double reach() const { return reach_; }  ///< [m]
  [[nodiscard]] const PoseLattice& lattice() const { return lattice_; }
  [[nodiscard]] int levels() const { return pyramid_.levels(); }

 private:
  struct Candidate;
  class Frontier;
  class TurnedScan;

  [[nodiscard]] int boundOf(double score) const;
  [[nodiscard]] int less(const PoseBlock& block) const;
  [[nodiscard]] double handicap(const PoseBlock& block) const;

  Points scan_;
  double reach_;
  int least_bound_;
  double least_rival_;
  PoseLattice lattice_;
  LikelihoodPyramid pyramid_;
};

}  // namespace omega_slam::matching
