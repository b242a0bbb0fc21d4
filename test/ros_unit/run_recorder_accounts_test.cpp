#include "nodes/common/run_recorder_accounts.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace omega_slam {
namespace {

diagnostic_msgs::DiagnosticArray say(
    const std::string& name, const std::vector<std::pair<std::string, std::string>>& values) {
  diagnostic_msgs::DiagnosticArray message;
  message.status.resize(1);
  message.status[0].name = name;
  for (const auto& [key, value] : values) {
    diagnostic_msgs::KeyValue pair;
    pair.key = key;
    pair.value = value;
    message.status[0].values.push_back(pair);
  }
  return message;
}

TEST(RunAccountsTest, CountsAreKeptByNodeAndCause) {
  RunAccounts accounts;
  accounts.update(say("scan_matcher: input", {{"accepted", "120"}, {"rate [Hz]", "10.00"}}));
  accounts.update(
      say("scan_matcher: faults", {{"rejected: no odometry", "3"}, {"repaired: clockwise", "7"}}));
  accounts.update(say("map_builder: input", {{"accepted", "12"}}));
  ASSERT_EQ(accounts.nodes().size(), 2U);
  const auto& scans = accounts.nodes().at("scan_matcher");
  EXPECT_EQ(scans.used, 120U);
  EXPECT_EQ(scans.rejections, (std::map<std::string, std::size_t>{{"no odometry", 3}}));
  EXPECT_EQ(scans.repairs, (std::map<std::string, std::size_t>{{"clockwise", 7}}));
}

TEST(RunAccountsTest, TheNewestCountStands) {
  RunAccounts accounts;
  accounts.update(say("scan_matcher: faults", {{"rejected: empty", "1"}}));
  accounts.update(say("scan_matcher: faults", {{"rejected: empty", "5"}}));
  EXPECT_EQ(accounts.nodes().at("scan_matcher").rejections.at("empty"), 5U);
}

TEST(RunAccountsTest, OtherStatusesAreSomebodyElses) {
  RunAccounts accounts;
  accounts.update(say("scan_matcher: health", {{"accepted", "9"}}));
  accounts.update(say("mobile_base: Battery", {{"Voltage", "16.1"}}));
  accounts.update(say(": input", {{"accepted", "9"}}));
  EXPECT_TRUE(accounts.nodes().empty());
}

}  // namespace
}  // namespace omega_slam
