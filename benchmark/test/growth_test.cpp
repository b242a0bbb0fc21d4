#include "slam/growth.h"

#include <gtest/gtest.h>

namespace omega_slam::experiments {
namespace {

/// Four scans, of which each is known by the x of its odometry; waits of 1, 2 and 3 s.
Records shortLog() {
  Records log(4);
  const double stamps[] = {10.0, 11.0, 13.0, 16.0};
  for (std::size_t k = 0; k < log.size(); ++k) {
    log[k].scan.stamp = stamps[k];
    log[k].T_odom_base.x = static_cast<double>(k);
  }
  return log;
}

TEST(DrivenOver, GoesToAndFro) {
  const Records whole = drivenOver(shortLog(), 3);
  std::vector<double> way;
  std::vector<double> stamps;
  for (const io::ScanRecord& record : whole) {
    way.push_back(record.T_odom_base.x);
    stamps.push_back(record.scan.stamp);
  }
  EXPECT_EQ(way, (std::vector<double>{0, 1, 2, 3, 2, 1, 0, 1, 2, 3}));
  EXPECT_EQ(stamps, (std::vector<double>{10, 11, 13, 16, 19, 21, 22, 23, 25, 28}));
}

TEST(DrivenOver, OnceIsTheLog) { EXPECT_EQ(drivenOver(shortLog(), 1).size(), 4U); }

}  // namespace
}  // namespace omega_slam::experiments
