#include "omega_slam/config/parameter_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "omega_slam/config/edit_distance.h"
#include "omega_slam/config/yaml_value.h"

namespace omega_slam::config {
namespace {

bool isWithin(double value, Range range) { return range.min <= value && value <= range.max; }

/// "a number in [0, 1]", "an integer >= 1" and so on.
std::string expectation(const std::string& what, Range range, Range unbounded) {
  const bool below = range.min > unbounded.min;
  const bool above = range.max < unbounded.max;
  if (below && above) {
    return fmt::format("{} in [{}, {}]", what, numberText(range.min), numberText(range.max));
  }
  if (below) {
    return fmt::format("{} >= {}", what, numberText(range.min));
  }
  return above ? fmt::format("{} <= {}", what, numberText(range.max)) : what;
}

std::string expectedNumber(Range range) { return expectation("a number", range, Range{}); }

std::string expectedInteger(Range range) {
  const Range all{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};
  return expectation("an integer", range, all);
}

bool isNumber(const YAML::Node& node) {
  const ValueKind kind = kindOf(node);
  return kind == ValueKind::kInteger || kind == ValueKind::kReal;
}

bool isNumberWithin(const YAML::Node& node, Range range) {
  return isNumber(node) && isWithin(numberOf(node), range);
}

/// Text as a YAML scalar that can be nothing but text.
std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string listText(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) {
    texts.push_back(numberText(value));
  }
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

}  // namespace

/// What a reader and its groups share.
struct ParameterReader::State {
  YAML::Node root;
  std::string prefix;  ///< ends in "/" unless empty
  std::string source;
  std::vector<std::string> faults;
  std::vector<Parameter> parameters;
  std::set<std::string> keys;    ///< of the parameters
  std::set<std::string> groups;  ///< paths, each ending in "/"

  /// The start of a sentence about a place in the source, with the line if it is known.
  [[nodiscard]] std::string where(const YAML::Node& node) const {
    if (source.empty()) {
      return "";
    }
    // Nodes that no parser has made are on line -1.
    const int line = node.IsDefined() ? node.Mark().line + 1 : 0;
    return line > 0 ? fmt::format("{}:{}: ", source, line) : source + ": ";
  }

  [[nodiscard]] std::string name(const std::string& path) const {
    return '`' + prefix + path + '`';
  }

  [[nodiscard]] std::string unknown(const YAML::Node& node, const std::string& path) const {
    std::vector<std::string> candidates;
    for (const Parameter& parameter : parameters) {
      candidates.push_back(parameter.key);
    }
    for (const std::string& group : groups) {
      const bool holds_the_key = path.compare(0, group.size(), group) == 0;
      if (!holds_the_key) {
        candidates.push_back(group.substr(0, group.size() - 1));
      }
    }
    std::string sentence = where(node) + "there is no parameter " + name(path);
    if (!candidates.empty()) {
      sentence += "; the nearest known key is " + name(nearestWord(path, candidates));
    }
    return sentence + '.';
  }

  /// Adds a sentence for each key of the map that nobody asked for, and for each that stands twice.
  void checkKeys(const YAML::Node& map, const std::string& path,
                 std::vector<std::string>& sentences) const {
    std::set<std::string> seen;
    for (const auto& entry : map) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
      const std::string full = path + key;
      if (!seen.insert(key).second) {
        sentences.push_back(where(entry.first) + name(full) + " is given twice.");
      } else if (groups.count(full + '/') > 0) {
        // The depth is bounded by the groups asked for, even where YAML's aliases make a loop.
        checkKeys(entry.second, full + '/', sentences);
      } else if (keys.count(full) == 0) {
        sentences.push_back(unknown(entry.first, full));
      }
    }
  }
};

ParameterReader::ParameterReader(const YAML::Node& root, const std::string& prefix,
                                 const std::string& source)
    : node_(root), state_(std::make_shared<State>()) {
  state_->prefix = prefix.empty() ? "" : prefix + '/';
  state_->source = source;
  if (kindOf(root) != ValueKind::kMap) {
    state_->faults.push_back(
        fmt::format("{}{} is {}, but a group of keys is expected.", state_->where(root),
                    prefix.empty() ? "the configuration" : '`' + prefix + '`', describe(root)));
    node_.reset(YAML::Node(YAML::NodeType::Map));
  }
  state_->root.reset(node_);
}

ParameterReader::ParameterReader(const YAML::Node& node, std::string path,
                                 std::shared_ptr<State> state)
    : node_(node), path_(std::move(path)), state_(std::move(state)) {}

void ParameterReader::read(const std::string& key, double& value, Range range) {
  const YAML::Node found = find(key);
  if (isNumberWithin(found, range)) {
    value = numberOf(found);
  } else {
    mismatch(key, found, expectedNumber(range));
  }
  record(key, expectedNumber(range), numberText(value));
}

void ParameterReader::read(const std::string& key, int& value, Range range) {
  const YAML::Node found = find(key);
  const Range representable{std::max<double>(range.min, std::numeric_limits<int>::min()),
                            std::min<double>(range.max, std::numeric_limits<int>::max())};
  if (isNumberWithin(found, representable) && std::trunc(numberOf(found)) == numberOf(found)) {
    value = static_cast<int>(numberOf(found));
  } else {
    mismatch(key, found, expectedInteger(range));
  }
  record(key, expectedInteger(range), std::to_string(value));
}

void ParameterReader::read(const std::string& key, bool& value) {
  const YAML::Node found = find(key);
  const std::string expected = "true or false";
  if (kindOf(found) == ValueKind::kBool) {
    value = boolOf(found);
  } else {
    mismatch(key, found, expected);
  }
  record(key, expected, value ? "true" : "false");
}

void ParameterReader::read(const std::string& key, std::string& value) {
  const YAML::Node found = find(key);
  const std::string expected = "text";
  if (kindOf(found) == ValueKind::kText) {
    value = found.Scalar();
  } else {
    mismatch(key, found, expected);
  }
  record(key, expected, quoted(value));
}

void ParameterReader::read(const std::string& key, std::string& value,
                           const std::vector<std::string>& choices) {
  const YAML::Node found = find(key);
  std::vector<std::string> quoted_choices;
  bool chosen = false;
  for (const std::string& choice : choices) {
    quoted_choices.push_back(quoted(choice));
    chosen = chosen || (kindOf(found) == ValueKind::kText && found.Scalar() == choice);
  }
  const std::string expected = fmt::format("{}", fmt::join(quoted_choices, " or "));
  if (chosen) {
    value = found.Scalar();
  } else {
    mismatch(key, found, expected);
  }
  record(key, expected, quoted(value));
}

void ParameterReader::read(const std::string& key, std::vector<double>& value, Range range) {
  const YAML::Node found = find(key);
  const std::string expected = expectation("a list of numbers", range, Range{});
  if (kindOf(found) == ValueKind::kList) {
    std::vector<double> numbers;
    for (const YAML::Node& element : found) {
      if (isNumberWithin(element, range)) {
        numbers.push_back(numberOf(element));
      } else {
        mismatch(fmt::format("{}[{}]", key, numbers.size()), element, expectedNumber(range));
        break;
      }
    }
    value = numbers.size() == found.size() ? numbers : value;
  } else {
    mismatch(key, found, expected);
  }
  record(key, expected, listText(value));
}

ParameterReader ParameterReader::group(const std::string& key) {
  const YAML::Node found = find(key);
  const std::string path = path_ + key + '/';
  state_->groups.insert(path);
  if (kindOf(found) == ValueKind::kMap) {
    return {found, path, state_};
  }
  mismatch(key, found, "a group of keys");
  return {YAML::Node(YAML::NodeType::Map), path, state_};
}

void ParameterReader::fault(const std::string& sentence) {
  const std::size_t first_word = std::min(sentence.find(' '), sentence.size());
  const std::string key = path_ + sentence.substr(0, first_word);
  std::string named = sentence;
  if (state_->keys.count(key) > 0) {
    named.replace(0, first_word, state_->name(key));
  }
  state_->faults.push_back(state_->where({}) + named);
}

void ParameterReader::faults(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    fault(sentence);
  }
}

const std::vector<Parameter>& ParameterReader::parameters() const { return state_->parameters; }

std::vector<std::string> ParameterReader::knownKeys() const {
  std::vector<std::string> keys;
  for (const Parameter& parameter : state_->parameters) {
    keys.push_back(parameter.key);
  }
  return keys;
}

void ParameterReader::finish() const {
  std::vector<std::string> sentences = state_->faults;
  state_->checkKeys(state_->root, "", sentences);
  if (!sentences.empty()) {
    throw ConfigurationError(fmt::format("{}", fmt::join(sentences, "\n")));
  }
}

YAML::Node ParameterReader::find(const std::string& key) const {
  // Only the const operator leaves the map as it is.
  const YAML::Node& map = node_;
  return map[key];
}

void ParameterReader::mismatch(const std::string& key, const YAML::Node& found,
                               const std::string& expected) {
  if (found.IsDefined()) {
    state_->faults.push_back(fmt::format("{}{} is {}, but {} is expected.", state_->where(found),
                                         state_->name(path_ + key), describe(found), expected));
  }
}

void ParameterReader::record(const std::string& key, const std::string& expected,
                             const std::string& value) {
  if (state_->keys.insert(path_ + key).second) {
    state_->parameters.push_back({path_ + key, expected, value});
  }
}

}  // namespace omega_slam::config
