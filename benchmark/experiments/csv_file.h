#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace omega_slam::experiments {

/// A table on its way to the disk, comma-separated, numbers to six digits.
class CsvFile {
 public:
  /// @throws std::runtime_error if it can't be written
  CsvFile(const std::filesystem::path& path, std::string_view header) : stream_(path) {
    stream_ << header << '\n';
    if (!stream_) {
      throw std::runtime_error(path.string() + ": can't be written.");
    }
  }

  template <class... Values>
  void row(const Values&... values) {
    std::string line;
    ((line += (line.empty() ? "" : ",") + cell(values)), ...);
    stream_ << line << '\n';
  }

 private:
  static std::string cell(double value) { return fmt::format("{:.6g}", value); }
  static std::string cell(std::string_view text) { return std::string(text); }
  static std::string cell(std::size_t count) { return fmt::format("{}", count); }

  std::ofstream stream_;
};

}  // namespace omega_slam::experiments
