#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace omega_slam {

/// What the status line tells of a run.
struct RunFigures {
  double elapsed{0.0};   ///< [s] of the run's clock
  double distance{0.0};  ///< [m] driven
  std::size_t keyframes{0};
  std::size_t loops{0};
  std::optional<double> share_seen;  ///< [0, 1] of the world
  std::optional<double> pose_error;  ///< [m] of the tracked pose, now
  std::string phase;                 ///< what the robot is at, such as "driving 3/12"
};

/// One line without its end, such as
/// "  83.4 s   21.70 m    74 keyframes   2 loops   61 % seen   error 0.03 m   driving 9/14".
/// What is not known yet is shown as "-".
[[nodiscard]] std::string formatStatus(const RunFigures& figures);

/// Shows the newest status on standard output: on a terminal by overwriting one line, elsewhere as
/// plain lines at a slower pace.
class StatusLine {
 public:
  /// @param terminal       whether standard output is a terminal
  /// @param plain_interval [s] between two plain lines
  StatusLine(bool terminal, double plain_interval);

  /// @param wall_time [s] of a clock that never stands still
  void show(const std::string& line, double wall_time);
  /// Ends the line, so that what is printed next starts on its own.
  void finish(const std::string& line);

 private:
  bool terminal_;
  double plain_interval_;
  std::optional<double> last_plain_;  ///< [s] wall time of the last plain line
};

}  // namespace omega_slam
