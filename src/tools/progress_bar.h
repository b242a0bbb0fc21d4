#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace omega_slam {

/// A line on stderr that fills up: live on a terminal, every tenth where the output is kept.
class ProgressBar {
 public:
  void show(double share, const std::string& remark) {
    const int percent = static_cast<int>(100.0 * share);
    const auto now = std::chrono::steady_clock::now();
    if (live_ ? now < next_ : percent / 10 == shown_ / 10) {
      return;
    }
    next_ = now + std::chrono::milliseconds(100);
    shown_ = percent;
    const auto filled = static_cast<std::size_t>(percent / 4);
    fmt::print(stderr, "{}[{:<25}] {:3d} %  {}{}", live_ ? "\r" : "", std::string(filled, '='),
               percent, remark, live_ ? "\033[K" : "\n");
    std::fflush(stderr);
  }

  /// Ends the line.
  void finish() const {
    if (live_) {
      fmt::print(stderr, "\n");
    }
  }

 private:
  bool live_{isatty(STDERR_FILENO) == 1};
  std::chrono::steady_clock::time_point next_{};
  int shown_{-10};
};

}  // namespace omega_slam
