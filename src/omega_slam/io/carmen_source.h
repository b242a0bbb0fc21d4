#pragma once

#include <filesystem>

#include "omega_slam/io/carmen_log.h"
#include "omega_slam/io/scan_source.h"

namespace omega_slam::io {

/// A CARMEN log as a source of scans. All beams of a scan are taken at once.
class CarmenSource : public ScanSource {
 public:
  /// @param T_base_laser CARMEN logs do not say where the laser sits; their odometry is mostly the
  /// laser's own
  /// @throws std::runtime_error as readCarmenLog
  CarmenSource(const std::filesystem::path& path, const geometry::Pose2& T_base_laser);

  [[nodiscard]] std::optional<ScanRecord> next() override;
  [[nodiscard]] double progress() const override;
  [[nodiscard]] std::map<std::string, std::size_t> dropped() const override;
  [[nodiscard]] std::string description() const override;

 private:
  CarmenLog log_;
  geometry::Pose2 T_base_laser_;
  std::size_t next_{0};
};

}  // namespace omega_slam::io
