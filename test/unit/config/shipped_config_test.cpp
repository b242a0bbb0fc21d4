// Documentation, shipped files and code say the same: the same keys, the same defaults, the same
// ranges. To take in another file, add a line to kSections.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "omega_slam/config/parameter_reader.h"
#include "omega_slam/config/slam_config.h"
#include "omega_slam/config/yaml_file.h"
#include "support/paths.h"

namespace omega_slam::config {
namespace {

using testing::HasSubstr;

/// Reads a section into a default configuration, as the node does.
template <class Config>
void readDefault(ParameterReader& reader) {
  Config config;
  read(reader, config);
}

/// One node's parameters: the file they ship in, the key they stand under, and who reads them.
struct Section {
  const char* file;
  const char* name;
  void (*read)(ParameterReader&);
};

const Section kSections[] = {
    {"slam.yaml", "motion_model", readDefault<MotionModelNodeConfig>},
    {"slam.yaml", "scan_matcher", readDefault<ScanMatcherNodeConfig>},
    {"slam.yaml", "graph_slam", readDefault<GraphSlamNodeConfig>},
    {"slam.yaml", "map_builder", readDefault<MapBuilderNodeConfig>},
};

/// What code, file or page says of one key.
struct Entry {
  std::string value;
  std::string expected;

  bool operator==(const Entry& other) const {
    return value == other.value && expected == other.expected;
  }
};

std::ostream& operator<<(std::ostream& os, const Entry& entry) {
  return os << entry.value << " (" << entry.expected << ")";
}

using Entries = std::map<std::string, Entry>;

Entries entriesOf(const YAML::Node& tree, const Section& section) {
  ParameterReader reader(tree, section.name);
  section.read(reader);
  EXPECT_NO_THROW(reader.finish());
  Entries entries;
  for (const Parameter& parameter : reader.parameters()) {
    entries[parameter.key] = {parameter.value, parameter.expected};
  }
  return entries;
}

Entries codeEntries(const Section& section) {
  return entriesOf(YAML::Node(YAML::NodeType::Map), section);
}

YAML::Node shippedTree(const Section& section) {
  const auto path = test::sourceFolder() / "config" / section.file;
  return loadYamlFile(path.string())[section.name];
}

std::vector<std::string> linesOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// Calls `visit` with the full name of each value of the tree that is not itself a map.
void visitLeaves(const YAML::Node& tree, const std::string& path,
                 const std::function<void(const std::string&, const YAML::Node&)>& visit) {
  for (const auto& entry : tree) {
    const std::string name = path + entry.first.Scalar();
    if (entry.second.IsMap()) {
      visitLeaves(entry.second, name + '/', visit);
    } else {
      visit(name, entry.first);
    }
  }
}

/// The cells of a row of a Markdown table, without spaces and back quotes around them.
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

/// What docs/parameters.md says below the heading "## <section>".
Entries documentedEntries(const Section& section) {
  Entries entries;
  bool inside = false;
  for (const std::string& line : linesOf(test::sourceFolder() / "docs" / "parameters.md")) {
    if (line.rfind("## ", 0) == 0) {
      inside = line == std::string("## ") + section.name;
    } else if (inside && line.rfind("| `", 0) == 0) {
      const std::vector<std::string> cells = cellsOf(line);
      EXPECT_EQ(cells.size(), 5U) << line;
      EXPECT_TRUE(entries.emplace(cells.at(0), Entry{cells.at(1), cells.at(3)}).second) << line;
      EXPECT_FALSE(cells.at(4).empty()) << line;
    }
  }
  return entries;
}

class ShippedConfig : public testing::TestWithParam<Section> {};

TEST_P(ShippedConfig, FileListsEveryKeyWithTheDefaultOfTheCode) {
  std::vector<std::string> file_keys;
  visitLeaves(shippedTree(GetParam()), "",
              [&](const std::string& name, const YAML::Node&) { file_keys.push_back(name); });
  const Entries code = codeEntries(GetParam());
  std::vector<std::string> code_keys;
  for (const auto& [key, entry] : code) {
    code_keys.push_back(key);
  }
  EXPECT_THAT(file_keys, testing::UnorderedElementsAreArray(code_keys));
  EXPECT_EQ(entriesOf(shippedTree(GetParam()), GetParam()), code);
}

TEST_P(ShippedConfig, FileExplainsEveryKeyAndStatesItsRange) {
  const Entries code = codeEntries(GetParam());
  const auto lines = linesOf(test::sourceFolder() / "config" / GetParam().file);
  visitLeaves(shippedTree(GetParam()), "", [&](const std::string& name, const YAML::Node& key) {
    const auto line = static_cast<std::size_t>(key.Mark().line);
    ASSERT_GE(line, 2U);
    EXPECT_THAT(lines[line - 2], HasSubstr("# ")) << name << " needs a line of advice.";
    EXPECT_THAT(lines[line - 1], testing::EndsWith(code.at(name).expected)) << name;
  });
}

TEST_P(ShippedConfig, PageListsEveryKeyWithDefaultAndRangeOfTheCode) {
  EXPECT_EQ(documentedEntries(GetParam()), codeEntries(GetParam()));
}

TEST_P(ShippedConfig, EveryKeyIsNamedWhenItsValueIsOfTheWrongKind) {
  for (const auto& [key, entry] : codeEntries(GetParam())) {
    YAML::Node tree(YAML::NodeType::Map);
    YAML::Node place(tree);
    std::istringstream parts(key);
    for (std::string part; std::getline(parts, part, '/');) {
      place.reset(place[part]);
    }
    place = YAML::Load("{a: group}");
    ParameterReader reader(tree, GetParam().name);
    GetParam().read(reader);
    try {
      reader.finish();
      ADD_FAILURE() << key << " takes a group of keys for a value";
    } catch (const ConfigurationError& error) {
      EXPECT_EQ(std::string(error.what()), std::string("`") + GetParam().name + '/' + key +
                                               "` is a group of keys, but " + entry.expected +
                                               " is expected.");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, ShippedConfig, testing::ValuesIn(kSections),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ShippedConfig, FileHoldsNoOtherSections) {
  for (const Section& section : kSections) {
    std::vector<std::string> known;
    for (const Section& other : kSections) {
      if (std::string(other.file) == section.file) {
        known.emplace_back(other.name);
      }
    }
    const auto path = test::sourceFolder() / "config" / section.file;
    for (const auto& entry : loadYamlFile(path.string())) {
      EXPECT_THAT(known, testing::Contains(entry.first.Scalar())) << section.file;
    }
  }
}

TEST(ShippedConfig, FileAndPageMarkTheSameFiveKeysAsBasic) {
  std::size_t file_marks = 0;
  for (const std::string& line : linesOf(test::sourceFolder() / "config" / "slam.yaml")) {
    file_marks += line.find("Basic: ") != std::string::npos ? 1U : 0U;
  }
  std::size_t page_marks = 0;
  for (const std::string& line : linesOf(test::sourceFolder() / "docs" / "parameters.md")) {
    page_marks += line.find("| **basic** ") != std::string::npos ? 1U : 0U;
  }
  EXPECT_EQ(file_marks, 5U);
  EXPECT_EQ(page_marks, 5U);
}

}  // namespace
}  // namespace omega_slam::config
