#pragma once

#include <ctime>

namespace omega_slam::experiments {

/// Time that this process has spent on processors [s], all its threads: what others do on the
/// machine counts little.
class CpuTimer {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_{now()};
};

}  // namespace omega_slam::experiments
