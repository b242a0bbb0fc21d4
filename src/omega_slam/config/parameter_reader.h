#pragma once

#include <yaml-cpp/yaml.h>

#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace omega_slam::config {

/// A configuration that can't be used. what() is one sentence for each fault; each names its key.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bounds of a number, both inclusive.
struct Range {
  double min{-std::numeric_limits<double>::infinity()};
  double max{std::numeric_limits<double>::infinity()};
};

/// Reads a tree of parameters strictly: a key of the wrong type or out of range, and a key that
/// nobody asked for, are faults. Absent keys leave the value (the default) alone. Faults are
/// collected; finish() throws them all at once.
///
/// The tree is YAML, from a file or made from ROS parameters; a quoted scalar is a string and never
/// a number.
class ParameterReader {
 public:
  /// @param where how messages name the tree, such as "scan_matcher" or "slam.yaml: scan_matcher"
  ParameterReader(YAML::Node root, std::string where);

  void read(const std::string& key, double& value, Range range = {});  ///< an integer is accepted
  void read(const std::string& key, int& value, Range range = {});  ///< 2.0 is accepted, 2.6 is not
  void read(const std::string& key, bool& value);
  void read(const std::string& key, std::string& value);  ///< a number is not accepted
  void read(const std::string& key, std::string& value, const std::vector<std::string>& choices);
  void read(const std::string& key, std::vector<double>& value);  ///< a list of numbers

  /// A group of keys below `key`; its faults and unknown keys are reported with this reader's.
  [[nodiscard]] ParameterReader group(const std::string& key);

  /// Adds a fault found by somebody else, such as a config's validate().
  void fault(const std::string& sentence);

  /// Every key that was asked for so far, in the form "group/key".
  [[nodiscard]] std::vector<std::string> knownKeys() const;

  /// @throws ConfigurationError if there were faults or unknown keys (with the nearest known key
  /// named)
  void finish() const;

 private:
  struct State;  ///< shared between a reader and its groups
  YAML::Node node_;
  std::string prefix_;
  std::shared_ptr<State> state_;
};

}  // namespace omega_slam::config
