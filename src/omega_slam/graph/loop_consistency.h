#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// The drive by its measured steps alone, from each node to the next, with the covariance of every
/// piece of it at hand.
///
/// Errors of steps are carried to the origin's frame, where those of pieces are differences of
/// sums: any piece takes O(1).
class OdometryChain {
 public:
  /// Of several constraints between two consecutive nodes, the one with the most information
  /// (determinant) counts; loops do not. O(constraints)
  explicit OdometryChain(const PoseGraph& graph);

  /// Squared Mahalanobis length of the pose by which two loops disagree: that of the cycle through
  /// one loop, along the drive, back through the other, and along the drive again. Chi-square with
  /// 3 degrees of freedom if both are right (Olson, "Recognizing places using spectrally clustered
  /// local matches", RAS 2009; Mangelson et al., "Pairwise consistent measurement set
  /// maximization", ICRA 2018, section IV). Says much where the loops' ends are close to each
  /// other, little after long pieces of the drive.
  /// @return none where a step between their ends is missing
  [[nodiscard]] std::optional<double> disagreement(const Constraint& a, const Constraint& b) const;

  /// Steps between the loops' ends along the drive, the longer of the two pieces; either loop may
  /// be named backwards.
  [[nodiscard]] static NodeId separation(const Constraint& a, const Constraint& b);

 private:
  std::vector<geometry::Pose2> poses_;  ///< seen from the first node of the part
  /// Sums over the steps up to a node, for twists in the frame of the part's first node.
  std::vector<Eigen::Matrix3d> covariances_;
  std::vector<std::size_t> parts_;  ///< numbered; a missing step begins a new one
};

/// What others say of a loop.
struct LoopSupport {
  std::size_t agreeing{0};
  std::size_t disagreeing{0};
};

struct SupportConfig {
  NodeId neighbourhood{10};  ///< [steps] between ends, within which loops are compared
  double gate{4.0};          ///< [standard deviations] up to which a disagreement is noise
};

/// Compares a new loop with others, such as the recent ones. None that is near, and nothing is
/// said.
[[nodiscard]] LoopSupport supportOf(const Constraint& loop, const std::vector<Constraint>& others,
                                    const OdometryChain& chain, const SupportConfig& config = {});

/// For each loop those that agree with it: near it and within the gate. Indices into `loops`,
/// ascending. A loop with such support is not a lone mistake, though many may share a cause: what
/// looks alike here and there.
/// @param loops indices of constraints
[[nodiscard]] std::vector<std::vector<std::size_t>> agreeingLoops(
    const PoseGraph& graph, const std::vector<std::size_t>& loops,
    const SupportConfig& config = {});

}  // namespace omega_slam::graph
