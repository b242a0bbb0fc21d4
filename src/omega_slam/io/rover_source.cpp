#include "omega_slam/io/rover_source.h"

#include <fmt/format.h>

namespace omega_slam::io {

RoverSource::RoverSource(const std::filesystem::path& path, const RoverGeometry& rover)
    : log_(readRoverLog(path, rover)) {}

std::optional<ScanRecord> RoverSource::next() {
  return next_ < log_.records.size() ? std::optional(log_.records[next_++]) : std::nullopt;
}

double RoverSource::progress() const {
  return static_cast<double>(next_) / static_cast<double>(log_.records.size());
}

std::map<std::string, std::size_t> RoverSource::dropped() const {
  std::map<std::string, std::size_t> dropped;
  if (log_.malformed_lines > 0) {
    dropped["malformed line (first: " + log_.first_fault + ")"] = log_.malformed_lines;
  }
  return dropped;
}

std::string RoverSource::description() const {
  return fmt::format("Rover's log with {} scans.", log_.records.size());
}

}  // namespace omega_slam::io
