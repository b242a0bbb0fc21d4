#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace omega_slam {

/// How far a run has come; facts only.
struct RunProgress {
  double time{0.0};            ///< [s] of the run's clock, newest stamp seen
  double elapsed{0.0};         ///< [s] of the run's clock since the first message
  double wall_time{0.0};       ///< [s] of a clock that never stands still, any origin
  std::string route_status;    ///< "driving k/n", "done", "stuck: <why>", or empty; of an
                               ///< exploration what explorationLine() says
  std::size_t keyframes{0};    ///< made so far
  std::size_t graph_poses{0};  ///< in the newest pose graph
  double graph_stamp{0.0};     ///< [s] newest keyframe of that graph
  double map_stamp{0.0};       ///< [s] newest keyframe drawn in the newest map
};

/// When the run is to end.
struct RunEndConfig {
  double duration{0.0};          ///< [s] of the run's clock; 0: with the route
  double settle_time{1.0};       ///< [s] of the run's clock that graph and map get at least
  double settle_deadline{20.0};  ///< [s] of wall time that they get at most
};

/// Decides when a run is over: its route is done, its exploration has ended, the robot is stuck, or
/// the time is up, and graph and map have caught up with the last keyframe of that time. Knows no
/// clock; every fact is handed in.
class RunEnd {
 public:
  enum class Phase { kRunning, kSettling, kOver };

  explicit RunEnd(const RunEndConfig& config) : config_(config) {}

  Phase update(const RunProgress& progress);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// Why the run ends, a phrase such as "route done"; empty while it goes on.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// Whether graph and map had caught up when the run was over.
  [[nodiscard]] bool settled() const { return settled_; }

 private:
  [[nodiscard]] std::string findReason(const RunProgress& progress) const;
  [[nodiscard]] bool hasSettled(const RunProgress& progress);

  RunEndConfig config_;
  Phase phase_{Phase::kRunning};
  std::string reason_;
  bool settled_{false};
  double end_time_{0.0};                         ///< [s] of the run's clock when settling began
  double end_wall_time_{0.0};                    ///< [s] likewise, of wall time
  std::optional<std::size_t> wanted_keyframes_;  ///< that the graph is to hold
  std::optional<double> wanted_stamp_;           ///< [s] of the graph that the map is to show
};

}  // namespace omega_slam
