#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/matching/matcher_factory.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/lost_judge.h"
#include "omega_slam/slam/pair_matcher.h"
#include "omega_slam/slam/relocaliser.h"
#include "omega_slam/slam/scan_tracker.h"
#include "omega_slam/slam/surroundings.h"
#include "omega_slam/slam/weighed_odometry.h"

namespace omega_slam::slam {

struct FrontEndConfig {
  double keyframe_translation{0.4};  ///< [m] a keyframe after so much driving,
  double keyframe_rotation{0.4};     ///< [rad] or turning,
  double keyframe_time{10.0};        ///< [s] or waiting; 0: never by time alone
  double min_confidence{0.5};        ///< [0, 1] matches below leave the odometry alone
  double max_speed{3.0};             ///< [m/s] odometry that claims more has jumped;
  double max_turn_rate{6.3};         ///< [rad/s] this too
  double lost_distance{1.0};  ///< [m] of driving, all of which the map contradicts, and one is lost
  SurroundingsConfig surroundings;
  matching::MatcherConfig matching;
  PlaceMatcherConfig places;  ///< that a lost robot may be at

  [[nodiscard]] std::vector<std::string> validate() const;

  /// @param motion since the last keyframe
  /// @param seconds since then
  [[nodiscard]] bool isKeyframeDue(const geometry::Pose2& motion, double seconds) const;
};

/// What one sweep has led to.
struct FrontEndResult {
  KeyframePtr keyframe;                        ///< the new keyframe, or null
  std::vector<graph::Constraint> constraints;  ///< that tie it to keyframes before
  std::optional<matching::MatchResult> match;  ///< where a match was tried
  bool match_trusted{false};                   ///< whether that match had a say
  bool is_lost{false};                         ///< the robot does not know where it is
  std::vector<std::string> remarks;            ///< what was odd, short stable phrases
  graph::NodeId keyframe_before{0};  ///< the newest before the sweep; the first has itself
  geometry::Pose2 T_keyframe_base;   ///< where the sweep was taken, seen from that
  /// Where the graph and the tracking put the base, `T_map_base`.
  Belief belief;
};

/// From sweeps to keyframes and constraints: every sweep is tracked on a map of the surroundings,
/// and some are kept.
///
/// Where the robot comes out of the dark, having driven on so far without a scan that its odometry
/// is unsure, and sees nothing that it knows, a stretch of keyframes begins: only the odometry ties
/// them to those before, until a loop does, and they are not drawn beside each other until then.
///
/// A robot that is lost (LostJudge) makes no keyframes, which would spoil the map, and is looked
/// for all over the graph (Relocaliser). Where it is found, the next keyframe is tied to what is
/// there, and not to the keyframe before.
///
/// Not thread-safe: one owner calls it.
class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndConfig& config = {});  ///< @throws std::invalid_argument

  /// @param prediction odometry at the sweep's stamp, with the covariance of the motion since the
  /// last keyframe
  [[nodiscard]] FrontEndResult process(const sensing::Sweep& sweep,
                                       const motion::Prediction& prediction);

  /// Takes over what the graph now believes of the keyframes.
  void believe(const graph::PoseGraph& graph);
  /// The same; `known` as for Surroundings::believe().
  void believe(const graph::PoseGraph& graph, graph::PathUncertainty& known);

  void reset();  ///< forgets all; the next sweep is keyframe 0

  [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }
  /// What is always wrong with the odometry, as far as it has been learnt.
  [[nodiscard]] OdometryFaults odometryFaults() const { return odometry_.faults(); }

 private:
  [[nodiscard]] FrontEndResult begin(const sensing::Sweep& sweep,
                                     const motion::Prediction& prediction);
  [[nodiscard]] TrackedScan follow(const matching::View& view, const OdometryStep& step);
  [[nodiscard]] bool isOutOfTheDark(const TrackedScan& tracked, const OdometryStep& step) const;
  [[nodiscard]] graph::NodeId next() const { return surroundings_.keyframes().back()->id + 1; }
  [[nodiscard]] KeyframePtr keep(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                                 graph::NodeId stretch) const;
  void makeKeyframe(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                    const TrackedScan& tracked, FrontEndResult& result);
  void beginStretch(const sensing::Sweep& sweep, const motion::Prediction& prediction,
                    const TrackedScan& tracked, FrontEndResult& result);
  void matchPairs(const TrackedScan& tracked, FrontEndResult& result) const;
  void resumeAt(const Relocation& found, const sensing::Sweep& sweep,
                const motion::Prediction& prediction, FrontEndResult& result);
  [[nodiscard]] Belief beliefInMap() const;
  void moveAlong(const geometry::Pose2& before, const geometry::Pose2& after);

  FrontEndConfig config_;
  ScanTracker tracker_;
  WeighedOdometry odometry_;
  Surroundings surroundings_;
  LostJudge judge_;
  PairMatcher pairs_;
  Relocaliser relocaliser_;
  Belief belief_;  ///< `T_local_base` at the last sweep
};

}  // namespace omega_slam::slam
