#pragma once

#include <yaml-cpp/yaml.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace omega_slam::config {

/// A configuration that can't be used. what() is one sentence for each fault, a line each; each
/// names its key.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bounds of a number, both inclusive. NaN is never within; an infinity only where it is a bound.
struct Range {
  double min{std::numeric_limits<double>::lowest()};
  double max{std::numeric_limits<double>::max()};
};

/// One parameter as it was read: for logs, and for tests that compare documentation with code.
struct Parameter {
  std::string key;       ///< in the form "group/key", without the reader's prefix
  std::string expected;  ///< type and range, such as "an integer in [1, 1000]"
  std::string value;     ///< the value in force, as YAML; the default where the key is absent
};

/// Reads a tree of parameters strictly: a key of the wrong type or out of range, and a key that
/// nobody asked for, are faults. Absent keys, and faulty ones, leave the value (the default) alone.
/// Faults are collected; finish() throws them all at once.
///
/// The tree is YAML, from a file or made from ROS parameters; a quoted scalar is a string and never
/// a number. Not thread-safe.
class ParameterReader {
 public:
  /// @param root   a map
  /// @param prefix what messages put before each key, such as "scan_matcher"; may be empty
  /// @param source what messages say before each sentence, such as "slam.yaml"; may be empty
  ParameterReader(const YAML::Node& root, const std::string& prefix,
                  const std::string& source = "");

  void read(const std::string& key, double& value, Range range = {});  ///< an integer is accepted
  void read(const std::string& key, int& value, Range range = {});  ///< 2.0 is accepted, 2.6 is not
  void read(const std::string& key, bool& value);
  void read(const std::string& key, std::string& value);  ///< a number is not accepted
  void read(const std::string& key, std::string& value, const std::vector<std::string>& choices);
  /// A list of numbers, each in the range.
  void read(const std::string& key, std::vector<double>& value, Range range = {});

  /// A group of keys below `key`, absent or not; its faults and unknown keys are reported with this
  /// reader's.
  [[nodiscard]] ParameterReader group(const std::string& key);

  /// Adds a fault found by somebody else, such as a config's validate(). A first word that is a key
  /// of this group is given its full name.
  void fault(const std::string& sentence);
  void faults(const std::vector<std::string>& sentences);

  /// Every parameter that was asked for so far, in that order, through this reader or its groups.
  [[nodiscard]] const std::vector<Parameter>& parameters() const;

  /// The keys of parameters().
  [[nodiscard]] std::vector<std::string> knownKeys() const;

  /// @throws ConfigurationError if there were faults or unknown keys (with the nearest known key
  /// named)
  void finish() const;

 private:
  struct State;  ///< shared between a reader and its groups

  ParameterReader(const YAML::Node& node, std::string path, std::shared_ptr<State> state);

  /// The value of a key, undefined if absent.
  [[nodiscard]] YAML::Node find(const std::string& key) const;
  void mismatch(const std::string& key, const YAML::Node& found, const std::string& expected);
  void record(const std::string& key, const std::string& expected, const std::string& value);

  YAML::Node node_;   ///< the map that this reader reads; an empty one if the group is absent
  std::string path_;  ///< of this group within the tree, ending in "/" unless empty
  std::shared_ptr<State> state_;
};

}  // namespace omega_slam::config
