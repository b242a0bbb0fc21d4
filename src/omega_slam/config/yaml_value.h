#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace omega_slam::config {

enum class ValueKind {
  kEmpty,    ///< nothing after the colon, ~ or null
  kBool,     ///< true, yes, on, and their opposites
  kInteger,  ///< decimal digits
  kReal,     ///< decimal with a point, or .nan, .inf
  kText,     ///< quoted, or anything that is none of the others
  kForeign,  ///< what readers of YAML disagree about (octal, hexadecimal, 1:30, !tags)
  kList,
  kMap
};

/// What a node is, by the rules of YAML 1.1 as roslaunch reads it, so that a file means the same to
/// a node and to the offline tool: `1e-3` is text, as there, since YAML 1.1 wants `1.0e-3`.
[[nodiscard]] ValueKind kindOf(const YAML::Node& node);

/// @pre the kind is kBool
[[nodiscard]] bool boolOf(const YAML::Node& node);

/// @pre the kind is kInteger or kReal. A number too large for a double is infinite.
[[nodiscard]] double numberOf(const YAML::Node& node);

/// The node for a message, such as `the text "fast"` or `a list of 3 values`.
[[nodiscard]] std::string describe(const YAML::Node& node);

/// A number in the fewest digits that read back as the same double, such as `0.1` or
/// `1.0e-6`.
[[nodiscard]] std::string numberText(double value);

}  // namespace omega_slam::config
