#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/correlative_matcher.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::slam {

struct LoopCloserConfig {
  double search_radius{3.0};  ///< [m] keyframes nearer than this are candidates
  int min_separation{20};     ///< keyframes between a candidate and the newest
  int max_candidates{3};      ///< tried for each new keyframe
  int neighbours{3};  ///< keyframes on each side of a candidate that make up its surroundings
  double min_confidence{0.8};  ///< [0, 1]
  /// Around where the graph believes the keyframe to be.
  matching::SearchWindow window{1.0, 0.3};
  matching::MatchConfig match;

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Finds places that the robot has been to before. Not thread-safe: one owner calls it.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserConfig& config = {});  ///< @throws std::invalid_argument

  /// Keyframes arrive in the order of their ids, without gaps.
  void addKeyframe(KeyframePtr keyframe);

  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }

  /// Matches keyframe `id` with earlier ones near it.
  /// @param poses `T_map_i` for keyframes 0, 1, ... as the graph now believes; must reach to `id`
  [[nodiscard]] std::vector<graph::Constraint> search(
      graph::NodeId id, const std::vector<geometry::Pose2>& poses) const;

  void reset();

 private:
  /// Earlier keyframes worth a match with `id`, nearest first.
  [[nodiscard]] std::vector<graph::NodeId> candidates(
      graph::NodeId id, const std::vector<geometry::Pose2>& poses) const;
  /// What a keyframe and its neighbours in time saw, in its frame.
  [[nodiscard]] matching::Reference surroundings(graph::NodeId center,
                                                 const std::vector<geometry::Pose2>& poses) const;

  LoopCloserConfig config_;
  matching::CorrelativeMatcher matcher_;
  std::vector<KeyframePtr> keyframes_;
};

}  // namespace omega_slam::slam
