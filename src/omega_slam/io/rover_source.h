#pragma once

#include <filesystem>

#include "omega_slam/io/rover_log.h"
#include "omega_slam/io/scan_source.h"

namespace omega_slam::io {

/// A log of the Mines ParisTech rover as a source of scans.
class RoverSource : public ScanSource {
 public:
  /// @throws std::runtime_error as readRoverLog
  explicit RoverSource(const std::filesystem::path& path, const RoverGeometry& rover = {});

  [[nodiscard]] std::optional<ScanRecord> next() override;
  [[nodiscard]] double progress() const override;
  [[nodiscard]] std::map<std::string, std::size_t> dropped() const override;
  [[nodiscard]] std::string description() const override;

 private:
  RoverLog log_;
  std::size_t next_{0};
};

}  // namespace omega_slam::io
