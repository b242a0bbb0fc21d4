#include "omega_slam/io/plain_text.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace omega_slam::io {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(PlainText, LinesAreCountedFromOne) {
  std::vector<std::pair<std::size_t, std::string>> lines;
  forEachLine("a\n\nb\r\nc",
              [&](std::size_t number, std::string_view line) { lines.emplace_back(number, line); });
  EXPECT_THAT(lines, ElementsAre(Pair(1, "a"), Pair(2, ""), Pair(3, "b\r"), Pair(4, "c")));
}

TEST(PlainText, WordsStandBetweenBlanks) {
  std::string_view rest = " \tone two\r";
  EXPECT_EQ(takeWord(rest), "one");
  EXPECT_EQ(takeWord(rest), "two");
  EXPECT_EQ(takeWord(rest), "");
  EXPECT_EQ(takeWord(rest), "");
}

TEST(ParseDecimal, ReadsAllWaysToWriteANumber) {
  const std::vector<std::pair<std::string, double>> numbers{
      {"0", 0.0},          {"7", 7.0},   {"+7", 7.0},     {"-7", -7.0},    {"007.50", 7.5},
      {"5.", 5.0},         {".5", 0.5},  {"-.5e1", -5.0}, {"1e3", 1000.0}, {"1E-3", 0.001},
      {"12.5e+2", 1250.0}, {"0.1", 0.1}, {"1e23", 1e23},  {"0e999", 0.0},  {"4.9e-324", 4.9e-324}};
  for (const auto& [word, value] : numbers) {
    EXPECT_EQ(parseDecimal(word), value) << word;
  }
  EXPECT_TRUE(std::signbit(parseDecimal("-0")));
}

TEST(ParseDecimal, WhatIsTooLargeIsInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parseDecimal("1e999"), kInfinity);
  EXPECT_EQ(parseDecimal("-1" + std::string(400, '0')), -kInfinity);
  EXPECT_EQ(parseDecimal("1e-999"), 0.0);
  EXPECT_EQ(parseDecimal("1e99999999999999999999"), kInfinity);
}

TEST(ParseDecimal, WhatIsNoNumberIsNaN) {
  for (const char* word : {"", "+", "-", ".", "e5", ".e5", "1e", "1e+", "1.2.3", "--1", "1-", "1,5",
                           "1x", "x1", "0x10", "inf", "nan", " 1", "1 "}) {
    EXPECT_TRUE(std::isnan(parseDecimal(word))) << word;
  }
}

}  // namespace
}  // namespace omega_slam::io
