#pragma once

#include <ros/time.h>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"

namespace omega_slam {

/// A keyframe as the graph needs it: no scan.
struct KeyframeArrival {
  std::uint64_t run{0};
  graph::NodeId id{0};
  ros::Time stamp;
  geometry::Pose2 T_odom_base;
};

/// Constraints that came in one message.
struct ConstraintArrival {
  std::uint64_t run{0};
  std::vector<graph::Constraint> constraints;
};

/// Something that may go into the graph now.
struct GraphStep {
  std::optional<KeyframeArrival> keyframe;  ///< a new node, or none:
  std::vector<graph::Constraint>
      constraints;  ///< that tie it, but no loops; or between older nodes
};

/// Puts what arrives on two topics in the order in which the graph can take it. Keyframes and
/// constraints may come in any order, twice, or from a run that is over; a keyframe waits for those
/// before it and for a constraint that ties it to them. Messages of another run are refused, save
/// for keyframe 0, which begins a new run. Not thread-safe.
class GraphAssembler {
 public:
  enum class Verdict {
    kTaken,
    kKnown,    ///< came before; nothing to do
    kNewRun,   ///< keyframe 0 of another run: all before is forgotten, and the graph must be too
    kOtherRun  ///< refused
  };

  Verdict add(const KeyframeArrival& keyframe);
  /// Those of a run that has not begun may be early: they are taken, and wait.
  Verdict add(ConstraintArrival arrival);

  /// Hands over what may go into the graph next, if there is something.
  [[nodiscard]] std::optional<GraphStep> next();

  /// Begins anew; what belongs to the run that ends is refused from here on.
  void reset();

  [[nodiscard]] std::uint64_t run() const { return run_; }  ///< 0: none yet
  [[nodiscard]] const std::vector<ros::Time>& stamps() const { return stamps_; }
  /// Keyframes that came but can't go in yet.
  [[nodiscard]] std::size_t waiting() const { return keyframes_.size(); }

 private:
  /// Ends, kind, and what it says: several matches may tie the same two keyframes.
  using Key =
      std::tuple<graph::NodeId, graph::NodeId, graph::ConstraintKind, double, double, double>;
  void forget();
  /// Takes the constraints that meet the condition out of those that wait.
  template <class Condition>
  [[nodiscard]] std::vector<graph::Constraint> take(Condition condition);

  std::uint64_t run_{0};
  std::uint64_t ended_run_{0};     ///< reset by hand
  std::vector<ros::Time> stamps_;  ///< of the keyframes handed over
  std::map<graph::NodeId, KeyframeArrival> keyframes_;
  std::deque<ConstraintArrival> early_;         ///< of runs that have not begun
  std::vector<graph::Constraint> constraints_;  ///< of this run, waiting
  std::set<Key> known_;                         ///< constraints of this run that came before
};

}  // namespace omega_slam
