#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace omega_slam::grid {

/// Writes a file whole or not at all: to a temporary name in the same folder, synced to the disk,
/// then renamed over `path`, then the folder is synced. Whoever reads `path` sees the old content
/// or the new one and never a part, even if the power fails. On failure the temporary file is
/// removed and what was at `path` is untouched. Missing folders are made. Where `path` is a link,
/// the file is that which it leads to; a device or a pipe (/dev/stdout) is written into, and stays.
///
/// @return an empty string, or one sentence that names the path and the cause
[[nodiscard]] std::string writeFileAtomically(const std::filesystem::path& path,
                                              std::string_view content);

/// Reads a whole file.
/// @throws std::runtime_error with one sentence that names the path and the cause
[[nodiscard]] std::string readFile(const std::filesystem::path& path);

}  // namespace omega_slam::grid
