#include "slam/gmapping_path.h"

#include <gtest/gtest.h>

#include <string>

#include "support/temporary_folder.h"

namespace omega_slam::experiments {
namespace {

io::ScanRecord scanOf(float first, float second) {
  io::ScanRecord record;
  record.scan.ranges = {first, second};
  return record;
}

std::string corrected(const std::string& ranges, const std::string& pose) {
  return "FLASER 2 " + ranges + ' ' + pose + ' ' + pose + " 1.1e9 host 1.1e9\n";
}

TEST(CorrectedScans, AreFoundByTheirRanges) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("a.log", corrected("1.00 2.00", "1 2 0.5") + corrected("9.00 9.00", "0 0 0") +
                                corrected("5.00 81.91", "3 4 0"));
  const std::vector<io::ScanRecord> log{scanOf(7.0F, 2.0F), scanOf(1.001F, 1.999F),
                                        scanOf(1.0F, 2.0F),
                                        scanOf(5.0F, std::numeric_limits<float>::infinity())};
  const CorrectedScans found = readCorrectedScans(path, log);
  EXPECT_EQ(found.scans, (std::vector<std::size_t>{1, 3}));
  ASSERT_EQ(found.poses.size(), 2U);
  EXPECT_EQ(found.poses[0].vector(), Eigen::Vector3d(1.0, 2.0, 0.5));
  EXPECT_EQ(found.poses[1].x, 3.0);
}

}  // namespace
}  // namespace omega_slam::experiments
