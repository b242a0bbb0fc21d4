#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/loop_closer.h"

namespace omega_slam {

/// Looks for loops in a thread of its own, so that scans never wait for it. Each keyframe is
/// searched once, as soon as the graph has a pose for it. The thread owns the slam::LoopCloser;
/// everybody else hands over keyframes and the graph through a mailbox, under a lock held only for
/// that.
class LoopSearch {
 public:
  /// Told of the constraints found for a keyframe, in the search's thread. @param run as in reset()
  using Found =
      std::function<void(const std::vector<graph::Constraint>& constraints, std::uint64_t run)>;

  /// @throws std::invalid_argument if the configuration is not valid
  LoopSearch(const slam::LoopCloserConfig& config, std::uint64_t run, Found found);
  ~LoopSearch();
  LoopSearch(const LoopSearch&) = delete;
  LoopSearch& operator=(const LoopSearch&) = delete;

  void addKeyframe(slam::KeyframePtr keyframe);  ///< in the order of their ids, without gaps
  void setGraph(graph::PoseGraph graph);         ///< as it is now solved
  void reset(std::uint64_t run);  ///< forgets all; what is being searched is thrown away
  void stop();                    ///< after the search that is going on

  [[nodiscard]] std::size_t searched() const { return searched_; }  ///< keyframes, in this run
  [[nodiscard]] std::size_t found() const { return found_count_; }  ///< loops, in this run

 private:
  void work();
  /// Waits for something to do and takes it over. @return whether to go on
  bool takeMail(graph::PoseGraph& graph);
  void search(graph::NodeId id, const graph::PoseGraph& graph);

  Found found_;
  // Of the thread alone.
  slam::LoopCloser closer_;
  std::uint64_t run_;
  // The mailbox.
  std::mutex mutex_;
  std::condition_variable mail_;
  std::deque<slam::KeyframePtr> new_keyframes_;
  graph::PoseGraph new_graph_;
  std::uint64_t new_run_;
  bool has_mail_{false};
  bool is_stopped_{false};

  std::atomic<std::size_t> searched_{0};
  std::atomic<std::size_t> found_count_{0};
  std::thread thread_;  ///< last: everything else must exist when it begins
};

}  // namespace omega_slam
