// As test/unit/config/shipped_config_test.cpp, for the nodes beside SLAM. To take in another one,
// add a line to kSections.

#include "support/shipped_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/common/navigator_config.h"
#include "nodes/common/run_recorder_config.h"
#include "nodes/common/simulator_config.h"

namespace omega_slam {
namespace {

using test::readDefault;
using test::ShippedSection;
using testing::IsEmpty;

const ShippedSection kSections[] = {
    {"simulator", "simulator.yaml", "", readDefault<SimulatorConfig>, "world"},
    {"route_follower", "route_follower.yaml", "", readDefault<RouteFollowerConfig>, "world"},
    {"navigator", "navigation.yaml", "", readDefault<NavigatorNodeConfig>},
    {"run_recorder", "run_recorder.yaml", "", readDefault<RunRecorderConfig>},
};

class ShippedNodeConfig : public testing::TestWithParam<ShippedSection> {};

TEST_P(ShippedNodeConfig, FileSaysWhatTheCodeDoes) {
  EXPECT_THAT(test::differencesOfFile(GetParam()), IsEmpty());
}

TEST_P(ShippedNodeConfig, PageSaysWhatTheCodeDoes) {
  EXPECT_THAT(test::differencesOfPage(GetParam()), IsEmpty());
}

TEST_P(ShippedNodeConfig, EveryKeyIsNamedWhenItsValueIsOfTheWrongKind) {
  EXPECT_THAT(test::keysThatTakeAnything(GetParam()), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Nodes, ShippedNodeConfig, testing::ValuesIn(kSections),
                         [](const auto& instance) { return instance.param.node; });

}  // namespace
}  // namespace omega_slam
