#include "nodes/common/run_recorder_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "omega_slam/config/yaml_file.h"
#include "support/paths.h"

namespace omega_slam {
namespace {

std::string faultsOf(const std::string& yaml) {
  RunRecorderConfig config;
  config::ParameterReader reader(YAML::Load(yaml), "run_recorder");
  read(reader, config);
  try {
    reader.finish();
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
  return {};
}

TEST(RunRecorderConfigTest, TheShippedFileHoldsEveryKeyWithItsDefault) {
  const YAML::Node shipped =
      config::loadYamlFile((test::sourceFolder() / "config/run_recorder.yaml").string());
  RunRecorderConfig config;
  config::ParameterReader reader(shipped, "run_recorder.yaml");
  read(reader, config);
  ASSERT_NO_THROW(reader.finish());
  std::vector<std::string> keys;
  for (const auto& entry : shipped) {
    keys.push_back(entry.first.as<std::string>());
  }
  EXPECT_THAT(keys, testing::UnorderedElementsAreArray(reader.knownKeys()));
  const RunRecorderConfig defaults;
  EXPECT_EQ(config.world, defaults.world);
  EXPECT_EQ(config.results, defaults.results);
  EXPECT_EQ(config.end.duration, defaults.end.duration);
  EXPECT_EQ(config.end.settle_time, defaults.end.settle_time);
  EXPECT_EQ(config.end.settle_deadline, defaults.end.settle_deadline);
  EXPECT_EQ(config.status_interval, defaults.status_interval);
  EXPECT_EQ(config.map_frame, defaults.map_frame);
  EXPECT_EQ(config.base_frame, defaults.base_frame);
}

TEST(RunRecorderConfigTest, FaultsNameTheirKeys) {
  EXPECT_EQ(faultsOf("{duration: 60, results: /tmp/results}"), "");
  EXPECT_THAT(faultsOf("duration: -1"), testing::HasSubstr("run_recorder/duration"));
  EXPECT_THAT(faultsOf("settle_deadline: soon"),
              testing::HasSubstr("run_recorder/settle_deadline"));
  EXPECT_THAT(faultsOf("results: \"\""), testing::HasSubstr("must name a folder"));
  EXPECT_THAT(faultsOf("durration: 5"), testing::HasSubstr("run_recorder/duration"));
}

}  // namespace
}  // namespace omega_slam
