#include "omega_slam/io/carmen_source.h"

#include <fmt/format.h>

namespace omega_slam::io {

CarmenSource::CarmenSource(const std::filesystem::path& path, const geometry::Pose2& T_base_laser)
    : log_(readCarmenLog(path)), T_base_laser_(T_base_laser) {}

std::optional<ScanRecord> CarmenSource::next() {
  if (next_ == log_.records.size()) {
    return std::nullopt;
  }
  const CarmenRecord& record = log_.records[next_++];
  return ScanRecord{record.scan, {T_base_laser_, false}, record.T_odom_base, {}};
}

double CarmenSource::progress() const {
  return static_cast<double>(next_) / static_cast<double>(log_.records.size());
}

std::map<std::string, std::size_t> CarmenSource::dropped() const {
  std::map<std::string, std::size_t> dropped;
  if (log_.malformed_lines > 0) {
    dropped["malformed line (first: " + log_.first_fault + ")"] = log_.malformed_lines;
  }
  return dropped;
}

std::string CarmenSource::description() const {
  const std::string backward =
      log_.backward_stamps == 0
          ? ""
          : fmt::format(
                ", {} of them with a stamp before the last one's: the order of the file is "
                "taken",
                log_.backward_stamps);
  return fmt::format("CARMEN log with {} scans{}.", log_.records.size(), backward);
}

}  // namespace omega_slam::io
