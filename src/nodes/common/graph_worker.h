#pragma once

#include <ros/time.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <variant>
#include <vector>

#include "nodes/common/diagnostics.h"
#include "nodes/common/graph_assembler.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/slam/back_end.h"

namespace omega_slam {

/// The graph as it was at one moment. Never changes, so it is shared freely between threads.
struct GraphSnapshot {
  std::uint64_t run{0};
  graph::PoseGraph graph;
  std::vector<ros::Time> stamps;  ///< of the keyframes
  geometry::Pose2 T_map_odom;     ///< at the newest keyframe; meaningless without keyframes
  double chi_square{0.0};         ///< of all constraints at these poses
  slam::BeliefAccount beliefs;

  /// Stamp of the newest keyframe; zero without keyframes.
  [[nodiscard]] ros::Time newest() const { return stamps.empty() ? ros::Time() : stamps.back(); }
};

using GraphSnapshotPtr = std::shared_ptr<const GraphSnapshot>;

/// Builds and solves the graph in a thread of its own. The thread alone owns the slam::BackEnd, so
/// a solve, however long, holds no lock: callbacks leave their messages in a mailbox and read the
/// newest snapshot, each under a lock held for a moment only.
class GraphWorker {
 public:
  /// Told of every new snapshot, in the worker's thread.
  using Changed = std::function<void(const GraphSnapshotPtr&)>;

  /// @param diagnostics must outlive the worker
  /// @throws std::invalid_argument if the configuration is not valid
  GraphWorker(const slam::BackEndConfig& config, Diagnostics& diagnostics, Changed changed);
  ~GraphWorker();
  GraphWorker(const GraphWorker&) = delete;
  GraphWorker& operator=(const GraphWorker&) = delete;

  void add(KeyframeArrival keyframe);
  void add(ConstraintArrival constraints);
  /// Forgets the graph. The next snapshot has no poses and carries the number of the run that
  /// ended.
  void reset();
  void stop();  ///< after the update that is going on

  [[nodiscard]] GraphSnapshotPtr snapshot() const;  ///< null while there was none

 private:
  struct Reset {};
  using Mail = std::variant<KeyframeArrival, ConstraintArrival, Reset>;
  void post(Mail mail);
  void work();
  void handle(const KeyframeArrival& keyframe);
  void handle(const ConstraintArrival& constraints);
  void handle(const Reset& reset);
  /// Puts into the graph what can go in. @return whether anything did
  bool grow();
  void reportHealth();
  void share(std::uint64_t run);

  Diagnostics& diagnostics_;
  Changed changed_;
  // Of the thread alone.
  slam::BackEnd back_end_;
  GraphAssembler assembler_;
  // Shared.
  mutable std::mutex mutex_;
  std::condition_variable has_mail_;
  std::vector<Mail> mailbox_;
  GraphSnapshotPtr snapshot_;
  bool is_stopped_{false};
  std::thread thread_;  ///< last: everything else must exist when it begins
};

}  // namespace omega_slam
