#pragma once

#include <unistd.h>

#include <fstream>

namespace omega_slam::experiments {

/// [bytes] of this process that are in memory just now.
inline double residentMemory() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace omega_slam::experiments
