#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/path_uncertainty.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/place_matcher.h"
#include "omega_slam/slam/relocaliser.h"

namespace omega_slam::slam {

struct LoopCloserConfig {
  double search_radius{3.0};  ///< [m] places seen from so near look alike
  int min_separation{20};     ///< keyframes to a candidate of the same stretch
  int max_candidates{3};      ///< tried for each new keyframe
  int neighbours{3};  ///< keyframes on each side of a candidate that make up its surroundings
  /// Places that are known so well from here need no loop: a match would hardly say more.
  double min_deviation{0.01};  ///< [m]
  /// Largest that is searched, however little is known.
  matching::SearchWindow max_window{6.0, 3.15};
  PlaceMatcherConfig place;

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Finds places that the robot has been to before. Not thread-safe: one owner calls it.
///
/// Where and how far to look comes from the uncertainty of the graph, not from a fixed radius: a
/// candidate is any earlier keyframe that, within two deviations of what the graph knows of it
/// from here, could have seen what the robot sees. A place is where the middle of a view lies, not
/// where the robot stood: one that comes back along a corridor looks the other way, and has the
/// walls in common with keyframes that lie ahead. Those come first of which most would be learnt.
/// The window that is searched spans two deviations to each side.
///
/// PlaceMatcher says what is to be believed. A loop from a wide window also waits until another
/// one, from another keyframe, tells the same of where the robot is.
///
/// A robot that drove on unseen may be anywhere: as long as no window is wide enough, its stretch
/// is looked for all over what came before (Relocaliser).
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserConfig& config = {});  ///< @throws std::invalid_argument

  /// Keyframes arrive in the order of their ids, without gaps.
  void addKeyframe(KeyframePtr keyframe);

  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }

  /// Matches keyframe `id` with earlier ones that may be near it.
  /// @param graph as it is now solved; must reach to `id`
  [[nodiscard]] std::vector<graph::Constraint> search(graph::NodeId id,
                                                      const graph::PoseGraph& graph);
  /// The same for the keyframe that a graph is seen from, for one who asks that for other ends too.
  /// @param known of that graph
  [[nodiscard]] std::vector<graph::Constraint> search(const graph::PoseGraph& graph,
                                                      graph::PathUncertainty& known);

  void reset();

 private:
  struct Candidate {
    graph::NodeId id{0};
    double gain{0.0};
    matching::SearchWindow window;
  };
  [[nodiscard]] bool isAdrift(graph::PathUncertainty& known) const;
  [[nodiscard]] std::vector<graph::Constraint> lookEverywhere(const graph::PoseGraph& graph,
                                                              graph::NodeId id);
  [[nodiscard]] std::vector<Candidate> candidates(const graph::PoseGraph& graph,
                                                  graph::PathUncertainty& known) const;
  [[nodiscard]] std::vector<graph::Constraint> tryCandidate(graph::NodeId id,
                                                            const Candidate& candidate,
                                                            const graph::PoseGraph& graph);
  [[nodiscard]] std::vector<graph::Constraint> confirm(const graph::Constraint& loop,
                                                       const graph::PoseGraph& graph);

  LoopCloserConfig config_;
  PlaceMatcher matcher_;
  Relocaliser relocaliser_;  ///< for stretches that are adrift
  std::vector<KeyframePtr> keyframes_;
  std::vector<Eigen::Vector2d> seen_;  ///< [m] the middle of what each saw, in its base frame
  std::vector<graph::Constraint> unconfirmed_;  ///< from wide windows, the newest last
};

}  // namespace omega_slam::slam
