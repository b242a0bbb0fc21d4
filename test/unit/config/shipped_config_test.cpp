// Shipped files, documentation and code say the same: the same keys, defaults and ranges. To take
// in another node of the library, add a line to kSections; nodes whose parameters only ROS knows
// are in test/ros_unit/shipped_config_test.cpp.

#include "support/shipped_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "omega_slam/config/exploration_config.h"
#include "omega_slam/config/map_publisher_config.h"
#include "omega_slam/config/slam_config.h"
#include "support/paths.h"

namespace omega_slam::config {
namespace {

using test::readDefault;
using test::ShippedSection;
using testing::IsEmpty;

const ShippedSection kSections[] = {
    {"motion_model", "slam.yaml", "motion_model", readDefault<MotionModelNodeConfig>},
    {"scan_matcher", "slam.yaml", "scan_matcher", readDefault<ScanMatcherNodeConfig>},
    {"graph_slam", "slam.yaml", "graph_slam", readDefault<GraphSlamNodeConfig>},
    {"map_builder", "slam.yaml", "map_builder", readDefault<MapBuilderNodeConfig>},
    {"map_publisher", "map_publisher.yaml", "", readDefault<MapPublisherNodeConfig>, "map_file"},
    {"frontier_explorer", "exploration.yaml", "", readDefault<FrontierExplorerNodeConfig>},
};

class ShippedConfig : public testing::TestWithParam<ShippedSection> {};

TEST_P(ShippedConfig, FileSaysWhatTheCodeDoes) {
  EXPECT_THAT(test::differencesOfFile(GetParam()), IsEmpty());
}

TEST_P(ShippedConfig, FileExplainsEveryKeyAndStatesItsRange) {
  EXPECT_THAT(test::unexplainedKeys(GetParam()), IsEmpty());
}

TEST_P(ShippedConfig, PageSaysWhatTheCodeDoes) {
  EXPECT_THAT(test::differencesOfPage(GetParam()), IsEmpty());
}

TEST_P(ShippedConfig, EveryKeyIsNamedWhenItsValueIsOfTheWrongKind) {
  EXPECT_THAT(test::keysThatTakeAnything(GetParam()), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Nodes, ShippedConfig, testing::ValuesIn(kSections),
                         [](const auto& instance) { return instance.param.node; });

TEST(ShippedConfig, WholeFileIsRead) {
  EXPECT_NO_THROW((void)loadSlamConfig((test::sourceFolder() / "config" / "slam.yaml").string()));
}

std::ptrdiff_t countLines(const std::string& file, const std::string& mark) {
  const auto lines = test::linesOfPackageFile(file);
  return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(mark) != std::string::npos;
  });
}

TEST(ShippedConfig, FileAndPageMarkFiveKeysAsBasic) {
  EXPECT_EQ(countLines("config/slam.yaml", "Basic: "), 5);
  EXPECT_EQ(countLines("docs/parameters.md", "| **basic** "), 5);
}

// A check that can't fail is none.
TEST(ShippedConfig, DifferencesAreSeen) {
  const auto read_other = [](ParameterReader& reader) {
    double resolution = 0.1;
    bool colour = false;
    reader.read("resolution", resolution, {0.001, 10.0});
    reader.read("colour", colour);
  };
  const ShippedSection other{"map_builder", "slam.yaml", "map_builder", read_other};
  EXPECT_THROW((void)test::differencesOfFile(other), ConfigurationError);
  EXPECT_THAT(test::differencesOfPage(other),
              testing::IsSupersetOf(
                  {"docs/parameters.md, map_builder, lacks colour.",
                   "docs/parameters.md, map_builder, says that resolution is 0.05 (a number in "
                   "[0.001, 10]), but the code says 0.1 (a number in [0.001, 10]).",
                   "docs/parameters.md, map_builder, has map_frame, which nobody reads."}));
}

}  // namespace
}  // namespace omega_slam::config
