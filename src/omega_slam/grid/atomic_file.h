#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace omega_slam::grid {

/// Writes a file whole or not at all: to a temporary name in the same folder, synced, then renamed.
/// Missing folders are made. @return an empty string, or why it failed, naming the path and the
/// cause
[[nodiscard]] std::string writeFileAtomically(const std::filesystem::path& path,
                                              std::string_view content);

}  // namespace omega_slam::grid
