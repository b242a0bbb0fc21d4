#include "omega_slam/config/parameter_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace omega_slam::config {
namespace {

using testing::ElementsAre;

/// What finish() throws after `use` has read from the YAML; empty if it throws nothing.
std::string faultsOf(const std::string& yaml, const std::function<void(ParameterReader&)>& use) {
  ParameterReader reader(YAML::Load(yaml), "scan_matcher");
  use(reader);
  try {
    reader.finish();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterReader, ReadsEveryType) {
  ParameterReader reader(
      YAML::Load("{d: 0.25, i: 7, b: true, s: odom, c: tf, l: [1, 2.5], g: {i: 9}}"), "node");
  double d = 0.0;
  int i = 0;
  int inner = 0;
  bool b = false;
  std::string s;
  std::string c;
  std::vector<double> l;
  reader.read("d", d);
  reader.read("i", i);
  reader.read("b", b);
  reader.read("s", s);
  reader.read("c", c, {"topic", "tf"});
  reader.read("l", l);
  reader.group("g").read("i", inner);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(d, 0.25);
  EXPECT_EQ(i, 7);
  EXPECT_EQ(inner, 9);
  EXPECT_TRUE(b);
  EXPECT_EQ(s, "odom");
  EXPECT_EQ(c, "tf");
  EXPECT_THAT(l, ElementsAre(1.0, 2.5));
}

TEST(ParameterReader, AbsentKeysKeepTheDefault) {
  double d = 0.5;
  std::string s = "odom";
  std::vector<double> l{1.0};
  EXPECT_EQ(faultsOf("{}",
                     [&](ParameterReader& reader) {
                       reader.read("d", d);
                       reader.read("s", s);
                       reader.group("g").read("l", l);
                     }),
            "");
  EXPECT_EQ(d, 0.5);
  EXPECT_EQ(s, "odom");
  EXPECT_THAT(l, ElementsAre(1.0));
}

TEST(ParameterReader, IntegerIsAcceptedForANumber) {
  double d = 0.0;
  EXPECT_EQ(faultsOf("d: 3", [&](ParameterReader& reader) { reader.read("d", d); }), "");
  EXPECT_EQ(d, 3.0);
}

TEST(ParameterReader, WholeRealIsAcceptedForAnIntegerAndNoOther) {
  int i = 0;
  EXPECT_EQ(faultsOf("i: 2.0", [&](ParameterReader& reader) { reader.read("i", i); }), "");
  EXPECT_EQ(i, 2);
  EXPECT_EQ(faultsOf("i: 2.6", [&](ParameterReader& reader) { reader.read("i", i); }),
            "`scan_matcher/i` is 2.6, but an integer is expected.");
  EXPECT_EQ(i, 2);
}

TEST(ParameterReader, IntegerBeyondItsTypeIsAFaultAndNotAnotherNumber) {
  int i = 1;
  EXPECT_EQ(faultsOf("i: 4294967297", [&](ParameterReader& reader) { reader.read("i", i); }),
            "`scan_matcher/i` is 4294967297, but an integer is expected.");
  EXPECT_EQ(i, 1);
}

TEST(ParameterReader, QuotedNumberIsText) {
  double d = 1.0;
  EXPECT_EQ(faultsOf("d: \"2\"", [&](ParameterReader& reader) { reader.read("d", d); }),
            "`scan_matcher/d` is the text \"2\" (a number is written without quotes, and as 1.0e-3 "
            "rather than 1e-3), but a number is expected.");
  std::string s;
  EXPECT_EQ(faultsOf("s: \"2\"", [&](ParameterReader& reader) { reader.read("s", s); }), "");
  EXPECT_EQ(s, "2");
}

TEST(ParameterReader, NumbersAndTruthsAreNotText) {
  std::string s = "odom";
  const auto read = [&](ParameterReader& reader) { reader.read("s", s); };
  EXPECT_EQ(faultsOf("s: 2", read), "`scan_matcher/s` is 2, but text is expected.");
  EXPECT_EQ(faultsOf("s: on", read), "`scan_matcher/s` is true, but text is expected.");
  EXPECT_EQ(faultsOf("s:", read), "`scan_matcher/s` is empty, but text is expected.");
  EXPECT_EQ(s, "odom");
}

TEST(ParameterReader, OnlyTruthsAreBool) {
  bool b = false;
  const auto read = [&](ParameterReader& reader) { reader.read("b", b); };
  EXPECT_EQ(faultsOf("b: 1", read), "`scan_matcher/b` is 1, but true or false is expected.");
  EXPECT_EQ(faultsOf("b: \"true\"", read),
            "`scan_matcher/b` is the text \"true\", but true or false is expected.");
  EXPECT_FALSE(b);
}

TEST(ParameterReader, BoundsAreInclusive) {
  double d = 0.5;
  const auto read = [&](ParameterReader& reader) { reader.read("d", d, {0.0, 1.0}); };
  EXPECT_EQ(faultsOf("d: 0", read), "");
  EXPECT_EQ(faultsOf("d: 1", read), "");
  EXPECT_EQ(faultsOf("d: 1.0000001", read),
            "`scan_matcher/d` is 1.0000001, but a number in [0, 1] is expected.");
  EXPECT_EQ(d, 1.0);
}

TEST(ParameterReader, SaysARangeThatIsOpenOnOneSide) {
  int i = 5;
  double d = 5.0;
  EXPECT_EQ(faultsOf("i: 0", [&](ParameterReader& reader) { reader.read("i", i, {1.0}); }),
            "`scan_matcher/i` is 0, but an integer >= 1 is expected.");
  const Range at_most{Range{}.min, 9.0};
  EXPECT_EQ(faultsOf("d: 10", [&](ParameterReader& reader) { reader.read("d", d, at_most); }),
            "`scan_matcher/d` is 10, but a number <= 9 is expected.");
}

TEST(ParameterReader, NanAndInfinityAreRefused) {
  double d = 0.5;
  int i = 5;
  const auto read_double = [&](ParameterReader& reader) { reader.read("d", d); };
  const auto read_int = [&](ParameterReader& reader) { reader.read("d", i); };
  for (const std::string text : {".nan", ".inf", "-.inf", "1.0e+999"}) {
    EXPECT_EQ(faultsOf("d: " + text, read_double),
              "`scan_matcher/d` is " + text + ", but a number is expected.");
    EXPECT_EQ(faultsOf("d: " + text, read_int),
              "`scan_matcher/d` is " + text + ", but an integer is expected.");
  }
  EXPECT_EQ(d, 0.5);
  EXPECT_EQ(i, 5);
}

TEST(ParameterReader, InfinityIsAcceptedWhereItIsABound) {
  double d = 0.5;
  const Range open{0.0, std::numeric_limits<double>::infinity()};
  const auto read = [&](ParameterReader& reader) { reader.read("d", d, open); };
  EXPECT_EQ(faultsOf("d: .inf", read), "");
  EXPECT_EQ(d, std::numeric_limits<double>::infinity());
  EXPECT_NE(faultsOf("d: .nan", read), "");
}

TEST(ParameterReader, ChoiceIsOneOfThoseGiven) {
  std::string s = "topic";
  const auto read = [&](ParameterReader& reader) { reader.read("s", s, {"topic", "tf"}); };
  EXPECT_EQ(faultsOf("s: ft", read),
            "`scan_matcher/s` is the text \"ft\", but \"topic\" or \"tf\" is expected.");
  EXPECT_EQ(s, "topic");
}

TEST(ParameterReader, ListNamesTheFaultyElement) {
  std::vector<double> l{7.0};
  const auto read = [&](ParameterReader& reader) { reader.read("l", l, {0.0, 9.0}); };
  EXPECT_EQ(faultsOf("l: [1, two]", read),
            "`scan_matcher/l[1]` is the text \"two\", but a number in [0, 9] is expected.");
  EXPECT_EQ(faultsOf("l: 1", read),
            "`scan_matcher/l` is 1, but a list of numbers in [0, 9] is expected.");
  EXPECT_THAT(l, ElementsAre(7.0));
  EXPECT_EQ(faultsOf("l: []", read), "");
  EXPECT_TRUE(l.empty());
}

TEST(ParameterReader, UnknownKeyIsNamedWithTheNearest) {
  double d = 0.5;
  int i = 1;
  EXPECT_EQ(faultsOf("keyframe_translatoin: 0.3",
                     [&](ParameterReader& reader) {
                       reader.read("keyframe_rotation", d);
                       reader.read("keyframe_translation", d);
                       reader.group("icp").read("max_iterations", i);
                     }),
            "there is no parameter `scan_matcher/keyframe_translatoin`; the nearest known key is "
            "`scan_matcher/keyframe_translation`.");
}

TEST(ParameterReader, KeyInTheWrongGroupIsFoundInTheRightOne) {
  double d = 0.5;
  int i = 1;
  EXPECT_EQ(faultsOf("max_iterations: 3",
                     [&](ParameterReader& reader) {
                       reader.read("min_confidence", d);
                       reader.group("icp").read("max_iterations", i);
                     }),
            "there is no parameter `scan_matcher/max_iterations`; the nearest known key is "
            "`scan_matcher/icp/max_iterations`.");
}

TEST(ParameterReader, UnknownGroupIsOneFault) {
  int i = 1;
  EXPECT_EQ(
      faultsOf("ipc: {max_iterations: 3, seed: 4}",
               [&](ParameterReader& reader) { reader.group("icp").read("n", i); }),
      "there is no parameter `scan_matcher/ipc`; the nearest known key is `scan_matcher/icp`.");
}

TEST(ParameterReader, AllFaultsComeTogetherALineEach) {
  double d = 0.5;
  int i = 1;
  EXPECT_EQ(
      faultsOf("{d: x, icp: {i: 0, j: 1}}",
               [&](ParameterReader& reader) {
                 reader.read("d", d);
                 ParameterReader icp = reader.group("icp");
                 icp.read("i", i, {1.0, 9.0});
                 icp.fault("i must be odd.");
                 reader.faults({"d is odd.", "icp/i is more than d."});
               }),
      "`scan_matcher/d` is the text \"x\", but a number is expected.\n"
      "`scan_matcher/icp/i` is 0, but an integer in [1, 9] is expected.\n"
      "`scan_matcher/icp/i` must be odd.\n"
      "`scan_matcher/d` is odd.\n"
      "`scan_matcher/icp/i` is more than d.\n"
      "there is no parameter `scan_matcher/icp/j`; the nearest known key is `scan_matcher/icp/i`.");
}

TEST(ParameterReader, KeyGivenTwiceIsAFault) {
  int i = 1;
  EXPECT_EQ(faultsOf("{icp: {i: 1, i: 2}}",
                     [&](ParameterReader& reader) { reader.group("icp").read("i", i); }),
            "`scan_matcher/icp/i` is given twice.");
}

TEST(ParameterReader, GroupMustBeAGroup) {
  int i = 1;
  const auto read = [&](ParameterReader& reader) { reader.group("icp").read("i", i); };
  EXPECT_EQ(faultsOf("icp: 3", read), "`scan_matcher/icp` is 3, but a group of keys is expected.");
  EXPECT_EQ(faultsOf("icp:", read),
            "`scan_matcher/icp` is empty, but a group of keys is expected.");
  EXPECT_EQ(i, 1);
}

TEST(ParameterReader, ValueMustNotBeAGroup) {
  int i = 1;
  EXPECT_EQ(faultsOf("i: {a: 1}", [&](ParameterReader& reader) { reader.read("i", i); }),
            "`scan_matcher/i` is a group of keys, but an integer is expected.");
}

TEST(ParameterReader, RootMustBeAGroup) {
  EXPECT_EQ(faultsOf("[1, 2]", [](ParameterReader&) {}),
            "`scan_matcher` is a list of 2 values, but a group of keys is expected.");
}

TEST(ParameterReader, SourceAndLineStandBeforeTheSentence) {
  ParameterReader reader(YAML::Load("map_builder:\n  resolution: x\n  colour: 1\n"), "", "a.yaml");
  double resolution = 0.05;
  reader.group("map_builder").read("resolution", resolution);
  reader.fault("nothing fits.");
  try {
    reader.finish();
    FAIL() << "finish() must throw";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(),
                 "a.yaml:2: `map_builder/resolution` is the text \"x\", but a number is expected.\n"
                 "a.yaml: nothing fits.\n"
                 "a.yaml:3: there is no parameter `map_builder/colour`; the nearest known key is "
                 "`map_builder/resolution`.");
  }
}

TEST(ParameterReader, ReportsTheParametersInForce) {
  ParameterReader reader(YAML::Load("{d: 0.25, g: {i: 3}}"), "node");
  double d = 0.5;
  int i = 1;
  bool b = true;
  std::string s = "odom";
  std::vector<double> l{1.0, 0.5};
  reader.read("d", d, {0.0, 1.0});
  reader.group("g").read("i", i, {1.0});
  reader.read("b", b);
  reader.read("s", s);
  reader.read("l", l);
  EXPECT_THAT(reader.knownKeys(), ElementsAre("d", "g/i", "b", "s", "l"));
  std::vector<std::string> lines;
  for (const Parameter& parameter : reader.parameters()) {
    lines.push_back(parameter.value + ", " + parameter.expected);
  }
  EXPECT_THAT(lines,
              ElementsAre("0.25, a number in [0, 1]", "3, an integer >= 1", "true, true or false",
                          "\"odom\", text", "[1, 0.5], a list of numbers"));
}

TEST(ParameterReader, LeavesTheTreeAsItIs) {
  const YAML::Node tree = YAML::Load("{a: 1}");
  ParameterReader reader(tree, "node");
  int i = 0;
  reader.read("a", i);
  reader.read("b", i);
  reader.group("c").read("d", i);
  EXPECT_EQ(tree.size(), 1U);
}

}  // namespace
}  // namespace omega_slam::config
