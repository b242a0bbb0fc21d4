#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam::test {

/// One node's parameters: who reads them, and where they are shipped and documented.
struct ShippedSection {
  std::string node;  ///< heading in docs/parameters.md
  std::string file;  ///< in config/
  std::string key;   ///< in the file, under which they stand; empty: they are the whole file
  void (*read)(config::ParameterReader&);  ///< into a default configuration
  std::string required{};  ///< a key of text that has no default: the page says "none" for it
};

std::ostream& operator<<(std::ostream& os, const ShippedSection& section);

/// The function for ShippedSection::read. The node's own read() is found by the type.
template <class Config>
void readDefault(config::ParameterReader& reader) {
  Config config;
  read(reader, config);
}

/// Where file and code differ: keys and defaults. A sentence each.
[[nodiscard]] std::vector<std::string> differencesOfFile(const ShippedSection& section);

/// Keys of the file above which there are not advice and, as the last line, type and range.
[[nodiscard]] std::vector<std::string> unexplainedKeys(const ShippedSection& section);

/// Where docs/parameters.md and code differ: keys, defaults, ranges.
[[nodiscard]] std::vector<std::string> differencesOfPage(const ShippedSection& section);

/// Keys whose value may be a group of keys, of the wrong kind for all of them, without a sentence
/// that names them.
[[nodiscard]] std::vector<std::string> keysThatTakeAnything(const ShippedSection& section);

/// The lines of a file of the package. @param path from the package's folder
[[nodiscard]] std::vector<std::string> linesOfPackageFile(const std::string& path);

}  // namespace omega_slam::test
