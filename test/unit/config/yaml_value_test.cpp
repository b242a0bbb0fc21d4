#include "omega_slam/config/yaml_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace omega_slam::config {
namespace {

struct KindCase {
  const char* yaml;
  ValueKind kind;
};

class KindOfScalar : public testing::TestWithParam<KindCase> {};

// What PyYAML, and with it roslaunch, makes of the same text.
TEST_P(KindOfScalar, AgreesWithRoslaunch) {
  EXPECT_EQ(kindOf(YAML::Load(GetParam().yaml)), GetParam().kind) << GetParam().yaml;
}

INSTANTIATE_TEST_SUITE_P(
    Scalars, KindOfScalar,
    testing::Values(KindCase{"0", ValueKind::kInteger}, KindCase{"-12", ValueKind::kInteger},
                    KindCase{"+3", ValueKind::kInteger}, KindCase{"0.5", ValueKind::kReal},
                    KindCase{".5", ValueKind::kReal}, KindCase{"5.", ValueKind::kReal},
                    KindCase{"-1.5e+3", ValueKind::kReal}, KindCase{"1.0e-3", ValueKind::kReal},
                    KindCase{".inf", ValueKind::kReal}, KindCase{"-.inf", ValueKind::kReal},
                    KindCase{".nan", ValueKind::kReal}, KindCase{"1e-3", ValueKind::kText},
                    KindCase{"1.0e3", ValueKind::kText}, KindCase{"inf", ValueKind::kText},
                    KindCase{"-.5", ValueKind::kText}, KindCase{"-x", ValueKind::kText},
                    KindCase{".", ValueKind::kText}, KindCase{"0,5", ValueKind::kText},
                    KindCase{"true", ValueKind::kBool}, KindCase{"off", ValueKind::kBool},
                    KindCase{"Yes", ValueKind::kBool}, KindCase{"y", ValueKind::kText},
                    KindCase{"tRue", ValueKind::kText}, KindCase{"~", ValueKind::kEmpty},
                    KindCase{"null", ValueKind::kEmpty}, KindCase{"\"1\"", ValueKind::kText},
                    KindCase{"'true'", ValueKind::kText}, KindCase{"!!str 1", ValueKind::kText},
                    KindCase{"\"\"", ValueKind::kText}, KindCase{"010", ValueKind::kForeign},
                    KindCase{"0x10", ValueKind::kForeign}, KindCase{"1_000", ValueKind::kForeign},
                    KindCase{"1:30", ValueKind::kForeign},
                    KindCase{"!degrees 90", ValueKind::kForeign},
                    KindCase{"odom", ValueKind::kText}, KindCase{"[1]", ValueKind::kList},
                    KindCase{"{a: 1}", ValueKind::kMap}));

TEST(YamlValue, NumberKeepsEveryDigit) {
  EXPECT_EQ(numberOf(YAML::Load("0.1")), 0.1);
  EXPECT_EQ(numberOf(YAML::Load("-2.5e-3")), -0.0025);
  EXPECT_EQ(numberOf(YAML::Load("-.inf")), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(numberOf(YAML::Load(".nan"))));
}

TEST(YamlValue, NumberTooLargeForADoubleIsInfinite) {
  EXPECT_EQ(numberOf(YAML::Load("1.0e+999")), std::numeric_limits<double>::infinity());
  EXPECT_EQ(numberOf(YAML::Load("-1.0e+999")), -std::numeric_limits<double>::infinity());
}

TEST(YamlValue, NumberTextReadsBackAsTheSameNumber) {
  for (const double value : {0.0, 0.1, 1.0 / 3.0, 1e-6, -1e300, 5e-324, 12345678.9, 0.35, 1e22,
                             std::numeric_limits<double>::max(), 100.0}) {
    const YAML::Node node = YAML::Load(numberText(value));
    ASSERT_TRUE(kindOf(node) == ValueKind::kReal || kindOf(node) == ValueKind::kInteger)
        << numberText(value);
    EXPECT_EQ(numberOf(node), value) << numberText(value);
  }
}

TEST(YamlValue, NumberTextIsShort) {
  EXPECT_EQ(numberText(0.35), "0.35");
  EXPECT_EQ(numberText(20.0), "20");
  EXPECT_EQ(numberText(1e-6), "1.0e-6");
  EXPECT_EQ(numberText(1e6), "1000000");
  EXPECT_EQ(numberText(-0.5), "-0.5");
  EXPECT_EQ(numberText(1e10), "1.0e+10");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-.inf");
}

TEST(YamlValue, DescribesWhatItIs) {
  EXPECT_EQ(describe(YAML::Load("fast")), "the text \"fast\"");
  EXPECT_EQ(describe(YAML::Load("[1, 2]")), "a list of 2 values");
  EXPECT_EQ(describe(YAML::Load("[1]")), "a list of 1 value");
  EXPECT_EQ(describe(YAML::Load("yes")), "true");
  EXPECT_EQ(describe(YAML::Load("~")), "empty");
  EXPECT_EQ(
      describe(YAML::Load("1e-3")),
      "the text \"1e-3\" (a number is written without quotes, and as 1.0e-3 rather than 1e-3)");
  EXPECT_EQ(describe(YAML::Load("010")),
            "\"010\", which not every reader of YAML takes for the same");
}

}  // namespace
}  // namespace omega_slam::config
