#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nodes/common/bag_log.h"
#include "ros_unit/bag_writer.h"
#include "support/temporary_folder.h"

namespace omega_slam::test {

/// A bag to be written, and then read with BagLog.
class BagFixture : public testing::Test {
 protected:
  BagFixture() : path_((folder_.path() / "log.bag").string()), writer_(path_) {}

  /// A robot at 1 m/s along x, odometry at 10 Hz from `begin` to `end` [s].
  void drive(double begin, double end) {
    for (int i = 0; begin + 0.1 * i <= end + 1e-9; ++i) {
      const double stamp = begin + 0.1 * i;
      writer_.odometry(stamp, {stamp - 100.0, 0.0, 0.0});
    }
  }

  void mountLaser() { writer_.transform(100.0, "base_link", "laser", {0.2, 0.0, 0.5}); }

  std::vector<io::ScanRecord> readAll(const BagLogOptions& options = {}) {
    writer_.close();
    BagLog log(path_, options);
    std::vector<io::ScanRecord> records;
    while (auto record = log.next()) {
      records.push_back(*record);
    }
    report_ = log.report();
    return records;
  }

  std::string refusal(const BagLogOptions& options = {}) {
    try {
      (void)readAll(options);
    } catch (const BagError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string path_;
  BagWriter writer_;
  BagLogReport report_;
};

}  // namespace omega_slam::test
