#include "slam/gmapping_path.h"

#include <cmath>

#include "omega_slam/io/carmen_log.h"

namespace omega_slam::experiments {
namespace {

constexpr float kSameRange = 0.011F;  // [m] logs have two decimals
constexpr double kSameShare = 0.98;   // of the beams

bool isSame(const sensing::LaserScan& a, const sensing::LaserScan& b) {
  if (a.ranges.size() != b.ranges.size()) {
    return false;
  }
  std::size_t same = 0;
  for (std::size_t k = 0; k < a.ranges.size(); ++k) {
    const bool neither = !std::isfinite(a.ranges[k]) && !std::isfinite(b.ranges[k]);
    same += neither || std::abs(a.ranges[k] - b.ranges[k]) < kSameRange ? 1 : 0;
  }
  return static_cast<double>(same) >= kSameShare * static_cast<double>(a.ranges.size());
}

}  // namespace

CorrectedScans readCorrectedScans(const std::filesystem::path& path,
                                  const std::vector<io::ScanRecord>& log) {
  CorrectedScans found;
  std::size_t next = 0;
  for (const io::CarmenRecord& corrected : io::readCarmenLog(path).records) {
    std::size_t k = next;
    while (k < log.size() && !isSame(corrected.scan, log[k].scan)) {
      ++k;
    }
    if (k < log.size()) {
      found.scans.push_back(k);
      found.poses.push_back(corrected.T_odom_base);
      next = k + 1;
    }
  }
  return found;
}

}  // namespace omega_slam::experiments
