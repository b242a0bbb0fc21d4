#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

#include "omega_slam/io/plain_text.h"
#include "support/seeds.h"

namespace omega_slam::io {
namespace {

/// By the standard library.
double oracle(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return value;
}

TEST(ParseDecimalLaws, GivesTheNearestDouble) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> digits(0, 17);
    std::uniform_int_distribution<int> power(-30, 30);
    std::uniform_real_distribution<double> size(-10.0, 10.0);
    for (int k = 0; k < 5000; ++k) {
      const double value = size(random) * std::pow(10.0, power(random));
      for (const std::string& word : {fmt::format("{:.{}e}", value, digits(random)),
                                      fmt::format("{:.{}f}", value, digits(random))}) {
        EXPECT_EQ(parseDecimal(word), oracle(word)) << word;
      }
    }
  }
}

TEST(ParseDecimalLaws, WhatAllDigitsWriteComesBack) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int k = 0; k < 5000; ++k) {
      const std::uint64_t bits = random();
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof value);
      if (std::isfinite(value)) {
        EXPECT_EQ(parseDecimal(fmt::format("{:.16e}", value)), value);
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::io
