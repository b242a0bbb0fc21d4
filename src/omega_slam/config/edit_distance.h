#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace omega_slam::config {

/// Levenshtein's distance: the fewest single letters to insert, delete or replace that turn one
/// word into the other. Bytes count as letters.
[[nodiscard]] std::size_t editDistance(const std::string& a, const std::string& b);

/// The word with the least distance to `word`, the first of equals; empty if there are no words.
[[nodiscard]] std::string nearestWord(const std::string& word,
                                      const std::vector<std::string>& words);

}  // namespace omega_slam::config
