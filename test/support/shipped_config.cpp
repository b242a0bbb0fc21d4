#include "support/shipped_config.h"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "omega_slam/config/yaml_file.h"
#include "support/paths.h"

namespace omega_slam::test {
namespace {

using config::ConfigurationError;
using config::Parameter;
using config::ParameterReader;

/// What code, file or page says of one key: default and range.
using Entries = std::map<std::string, std::string>;

std::string entryOf(const std::string& value, const std::string& expected) {
  return value + " (" + expected + ")";
}

YAML::Node emptyTree() { return YAML::Node(YAML::NodeType::Map); }

YAML::Node shippedTree(const ShippedSection& section) {
  const YAML::Node file = config::loadYamlFile((sourceFolder() / "config" / section.file).string());
  return section.key.empty() ? file : file[section.key];
}

std::vector<Parameter> parametersOf(const YAML::Node& tree, const ShippedSection& section) {
  YAML::Node complete = YAML::Clone(tree);
  if (!section.required.empty()) {
    complete[section.required] = "given";
  }
  ParameterReader reader(complete, section.node);
  section.read(reader);
  reader.finish();
  return reader.parameters();
}

Entries entriesOf(const YAML::Node& tree, const ShippedSection& section) {
  Entries entries;
  for (const Parameter& parameter : parametersOf(tree, section)) {
    const bool is_required = parameter.key == section.required;
    entries[parameter.key] = entryOf(is_required ? "none" : parameter.value, parameter.expected);
  }
  return entries;
}

/// Calls `visit` with the full name and the node of each key whose value is not itself a map.
void visitKeys(const YAML::Node& tree, const std::string& path,
               const std::function<void(const std::string&, const YAML::Node&)>& visit) {
  for (const auto& entry : tree) {
    const std::string name = path + entry.first.Scalar();
    if (entry.second.IsMap()) {
      visitKeys(entry.second, name + '/', visit);
    } else {
      visit(name, entry.first);
    }
  }
}

std::vector<std::string> differences(const Entries& code, const Entries& other,
                                     const std::string& where) {
  std::vector<std::string> sentences;
  for (const auto& [key, entry] : code) {
    const auto found = other.find(key);
    if (found == other.end()) {
      sentences.push_back(where + " lacks " + key + ".");
    } else if (found->second != entry) {
      sentences.push_back(where + " says that " + key + " is " + found->second +
                          ", but the code says " + entry + ".");
    }
  }
  for (const auto& [key, entry] : other) {
    if (code.count(key) == 0) {
      sentences.push_back(where + " has " + key + ", which nobody reads.");
    }
  }
  return sentences;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool isComment(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  return first != std::string::npos && line[first] == '#';
}

/// The cells of a row of a Markdown table, without the spaces and back quotes around them.
std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto first = cell.find_first_not_of(" `");
    const auto last = cell.find_last_not_of(" `");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// What docs/parameters.md says below the heading "## <node>": key, default, unit, range, meaning.
Entries documentedEntries(const ShippedSection& section) {
  Entries entries;
  bool inside = false;
  for (const std::string& line : linesOfPackageFile("docs/parameters.md")) {
    if (line.rfind("## ", 0) == 0) {
      inside = line == "## " + section.node;
    } else if (inside && line.rfind("| `", 0) == 0) {
      const auto cells = cellsOf(line);
      const bool complete = cells.size() == 5 && !cells[4].empty();
      if (!complete || !entries.emplace(cells[0], entryOf(cells[1], cells[3])).second) {
        throw std::runtime_error("docs/parameters.md: this row is not complete, or not new: " +
                                 line);
      }
    }
  }
  return entries;
}

/// A tree in which one key is given a group of keys for a value.
YAML::Node treeWithGroupAt(const std::string& key) {
  YAML::Node tree = emptyTree();
  YAML::Node place(tree);
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '/');) {
    place.reset(place[part]);
  }
  place["inner"] = 1;
  return tree;
}

}  // namespace

std::ostream& operator<<(std::ostream& os, const ShippedSection& section) {
  return os << section.node;
}

std::vector<std::string> differencesOfFile(const ShippedSection& section) {
  Entries listed;
  visitKeys(shippedTree(section), "",
            [&](const std::string& name, const YAML::Node&) { listed[name] = ""; });
  const Entries code = entriesOf(emptyTree(), section);
  for (const auto& [key, entry] : entriesOf(shippedTree(section), section)) {
    if (listed.count(key) > 0) {
      listed[key] = entry;
    }
  }
  return differences(code, listed, section.file);
}

std::vector<std::string> unexplainedKeys(const ShippedSection& section) {
  const auto lines = linesOfPackageFile("config/" + section.file);
  std::map<std::string, std::string> expected;
  for (const Parameter& parameter : parametersOf(emptyTree(), section)) {
    expected[parameter.key] = parameter.expected;
  }
  std::vector<std::string> sentences;
  visitKeys(shippedTree(section), "", [&](const std::string& name, const YAML::Node& key) {
    const auto line = static_cast<std::size_t>(key.Mark().line);
    const bool explained = line >= 2 && isComment(lines[line - 1]) && isComment(lines[line - 2]);
    if (!explained || !endsWith(lines[line - 1], expected[name])) {
      sentences.push_back(section.file + ": above " + name +
                          " there must be advice and then the line: " + expected[name]);
    }
  });
  return sentences;
}

std::vector<std::string> differencesOfPage(const ShippedSection& section) {
  return differences(entriesOf(emptyTree(), section), documentedEntries(section),
                     "docs/parameters.md, " + section.node + ",");
}

std::vector<std::string> keysThatTakeAnything(const ShippedSection& section) {
  std::vector<std::string> keys;
  for (const Parameter& parameter : parametersOf(emptyTree(), section)) {
    if (parameter.key == section.required) {
      continue;
    }
    std::string said;
    try {
      (void)parametersOf(treeWithGroupAt(parameter.key), section);
    } catch (const ConfigurationError& error) {
      said = error.what();
    }
    if (said != "`" + section.node + '/' + parameter.key + "` is a group of keys, but " +
                    parameter.expected + " is expected.") {
      keys.push_back(parameter.key + ": " + said);
    }
  }
  return keys;
}

std::vector<std::string> linesOfPackageFile(const std::string& path) {
  std::ifstream file(sourceFolder() / path);
  if (!file) {
    throw std::runtime_error(path + " can't be read.");
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace omega_slam::test
