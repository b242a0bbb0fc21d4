#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/matcher_factory.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/slam/keyframe.h"

namespace omega_slam::slam {

struct FrontEndConfig {
  double keyframe_translation{0.3};  ///< [m] a keyframe after so much driving,
  double keyframe_rotation{0.35};    ///< [rad] or turning,
  double keyframe_time{10.0};        ///< [s] or waiting; 0: never by time alone
  int local_keyframes{6};            ///< the newest keyframes whose points a scan is matched with
  double min_confidence{0.5};        ///< [0, 1] matches below leave the odometry alone
  matching::MatcherConfig matching;

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// What one sweep has led to.
struct FrontEndResult {
  KeyframePtr keyframe;                        ///< the new keyframe, or null
  std::vector<graph::Constraint> constraints;  ///< that tie it to the keyframes before
  std::optional<matching::MatchResult> match;  ///< where a match was tried
  bool match_trusted{false};                   ///< whether that match became a constraint
};

/// From sweeps to keyframes and constraints: decides what is kept, and matches it with the newest
/// keyframes. Not thread-safe: one owner calls it.
class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndConfig& config = {});  ///< @throws std::invalid_argument

  /// @param prediction odometry at the sweep's stamp, with the covariance of the motion since the
  /// last keyframe
  [[nodiscard]] FrontEndResult process(const sensing::Sweep& sweep,
                                       const motion::Prediction& prediction);

  void reset();  ///< forgets all; the next sweep is keyframe 0

 private:
  struct LocalKeyframe {
    KeyframePtr keyframe;
    geometry::Pose2 T_local_base;  ///< in a local frame that drifts, but slowly
    matching::View view;           ///< from the base
  };
  /// Constraints from the newest keyframe to a fresh one; the match, where trusted, moves the fresh
  /// one.
  void tieToNewest(LocalKeyframe& fresh, const motion::Prediction& prediction,
                   FrontEndResult& result) const;
  [[nodiscard]] bool isKeyframeDue(const geometry::Pose2& motion, double seconds) const;
  /// What the local keyframes saw, in the frame of the newest.
  [[nodiscard]] matching::Reference surroundings() const;

  FrontEndConfig config_;
  std::unique_ptr<const matching::ScanMatcher> matcher_;
  std::deque<LocalKeyframe> local_;
  graph::NodeId next_id_{0};
};

}  // namespace omega_slam::slam
