#pragma once

#include <ctime>

namespace omega_slam::experiments {

/// Adds the processor time [s] that this thread spends in the timer's scope to a sum.
class ThreadTimer {
 public:
  explicit ThreadTimer(double& sum) : sum_(&sum) {}
  ~ThreadTimer() { *sum_ += now() - start_; }
  ThreadTimer(const ThreadTimer&) = delete;
  ThreadTimer& operator=(const ThreadTimer&) = delete;

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double* sum_;
  double start_{now()};
};

}  // namespace omega_slam::experiments
