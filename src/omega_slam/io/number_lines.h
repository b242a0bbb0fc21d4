#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace omega_slam::io {

/// One line of a table of numbers, and where it stands.
struct NumberLine {
  int line{0};  ///< counted from 1
  std::vector<double> values;
};

/// Reads a text file of so many finite numbers a line, separated by blanks. Empty lines and what
/// follows a # are skipped.
/// @param columns what stands in a line, such as "stamp x y theta": for messages, and for how many
/// @throws std::runtime_error with one sentence that names the file, the line and the cause; also
/// for a file without any numbers
[[nodiscard]] std::vector<NumberLine> readNumberLines(const std::filesystem::path& path,
                                                      const std::string& columns);

}  // namespace omega_slam::io
