#include "nodes/common/run_recorder_status.h"

#include <fmt/format.h>

#include <cstdio>

namespace omega_slam {

std::string formatStatus(const RunFigures& figures) {
  const std::string seen =
      figures.share_seen ? fmt::format("{:3.0f} %", 100.0 * *figures.share_seen) : "  -";
  const std::string error = figures.pose_error ? fmt::format("{:.3f} m", *figures.pose_error) : "-";
  return fmt::format("{:6.1f} s  {:7.2f} m  {:4d} keyframes  {:3d} loops  {} seen  error {}  {}",
                     figures.elapsed, figures.distance, figures.keyframes, figures.loops, seen,
                     error, figures.phase);
}

StatusLine::StatusLine(bool terminal, double plain_interval)
    : terminal_(terminal), plain_interval_(plain_interval) {}

void StatusLine::show(const std::string& line, double wall_time) {
  if (terminal_) {
    // Back to the first column, the line, and what an older and longer line has left behind wiped.
    fmt::print("\r{}\x1b[K", line);
  } else if (!last_plain_ || wall_time - *last_plain_ >= plain_interval_) {
    fmt::print("{}\n", line);
    last_plain_ = wall_time;
  }
  std::fflush(stdout);
}

void StatusLine::finish(const std::string& line) {
  fmt::print(terminal_ ? "\r{}\x1b[K\n" : "{}\n", line);
  std::fflush(stdout);
}

}  // namespace omega_slam
