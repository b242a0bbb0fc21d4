#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/path_uncertainty.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/local_map.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/place_matcher.h"

namespace omega_slam::slam {

struct SurroundingsConfig {
  double radius{10.0};         ///< [m] keyframes taken so near to the newest are drawn
  double max_deviation{0.15};  ///< [m] and known so well from it; [rad] too
  int max_keyframes{20};       ///< so many of them at most, the nearest

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// What the robot is in the midst of: a LocalMap of the keyframes around, of this pass and of
/// earlier ones. Scans are laid on it.
///
/// It has a frame of its own, which drifts as little as the matches with it do. Keyframes of
/// earlier passes come in when the robot comes near them, but only once the graph knows well where
/// they lie from here: else walls would stand twice. When the graph has moved what is drawn against
/// itself by a wall's width, all is drawn anew, and the frame is the graph's.
///
/// Not thread-safe.
class Surroundings {
 public:
  /// @throws std::invalid_argument
  Surroundings(const SurroundingsConfig& config, const matching::LocalMapConfig& map);

  /// Draws a keyframe, the next in order of their ids.
  /// @param T_local_base where it was tracked
  void add(const KeyframePtr& keyframe, const geometry::Pose2& T_local_base);

  /// Takes over what the graph believes. It may lag behind by some keyframes.
  /// @return `T_local_base` of the newest keyframe from now on
  geometry::Pose2 believe(const graph::PoseGraph& graph);
  /// The same, for one who asks how well the graph is known for other ends too.
  /// @param known of that graph, from the newest keyframe, which it must know
  geometry::Pose2 believe(const graph::PoseGraph& graph, graph::PathUncertainty& known);

  /// Draws also what was seen between keyframes, if the robot has moved since the last drawing: it
  /// makes walls more certain than the few keyframes can. Forgotten some keyframes later, when all
  /// is drawn anew.
  /// @param view from the base
  void addGlance(const matching::View& view, const geometry::Pose2& T_local_base);

  /// Wipes what is drawn, in the same frame: a stretch begins. Its first keyframe is to be added
  /// next.
  void leave();

  /// Draws the surroundings of an earlier keyframe, of its stretch, and nothing else, in the
  /// graph's frame, as it was believed last. A keyframe is to be added next.
  /// @param center one whose pose is known
  void moveTo(graph::NodeId center);

  [[nodiscard]] const matching::LocalMap& map() const { return map_; }
  [[nodiscard]] bool isDrawn(graph::NodeId id) const { return drawn_.count(id) > 0; }
  /// `T_local_base` of a keyframe that is drawn.
  [[nodiscard]] const geometry::Pose2& poseOf(graph::NodeId id) const { return drawn_.at(id); }
  [[nodiscard]] const std::vector<KeyframePtr>& keyframes() const { return keyframes_; }
  /// What the graph said last of the keyframes.
  [[nodiscard]] KnownPlaces known() const { return {keyframes_, poses_}; }
  /// `T_local_base` of the newest keyframe; there must be one.
  [[nodiscard]] const geometry::Pose2& newest() const { return drawn_.rbegin()->second; }
  /// `T_map_local`, by the newest keyframe that the graph knew last.
  [[nodiscard]] const geometry::Pose2& mapFromLocal() const { return T_map_local_; }

 private:
  struct Glance {
    graph::NodeId keyframe{0};        ///< before it
    geometry::Pose2 T_keyframe_base;  ///< seen from that
    matching::View view;              ///< from the base
  };
  using Drawn = std::map<graph::NodeId, geometry::Pose2>;  ///< `T_local_base` of each

  [[nodiscard]] std::vector<graph::NodeId> wanted(const graph::PoseGraph& graph,
                                                  graph::PathUncertainty& known) const;
  [[nodiscard]] bool hasBent(graph::NodeId newest) const;
  void redraw(graph::NodeId newest, const std::vector<graph::NodeId>& wanted);
  void draw(graph::NodeId id, const geometry::Pose2& T_local_base);

  SurroundingsConfig config_;
  matching::LocalMap map_;
  std::vector<KeyframePtr> keyframes_;
  std::vector<geometry::Pose2> poses_;  ///< `T_map_base` of those that the graph knows
  Drawn drawn_;
  std::deque<Glance> glances_;
  geometry::Pose2 T_map_local_;
};

}  // namespace omega_slam::slam
