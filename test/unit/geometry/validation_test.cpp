#include "omega_slam/geometry/validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace omega_slam::geometry {
namespace {

TEST(Violations, NameTheFieldAndTheBound) {
  Violations violations;
  violations.requireAtLeast("low", 0.5, 1.0);
  violations.requireAbove("equal", 1.0, 1.0);
  violations.requireWithin("far", 3.0, 0.0, 2.0);
  violations.requireAtLeast("fine", 1.0, 1.0);
  ASSERT_EQ(violations.sentences().size(), 3U);
  EXPECT_THAT(violations.sentences()[0], testing::HasSubstr("low is 0.5"));
  EXPECT_THAT(violations.sentences()[1], testing::HasSubstr("equal"));
  EXPECT_THAT(violations.sentences()[2], testing::HasSubstr("within 0 and 2"));
}

TEST(Violations, NaNIsAlwaysAFault) {
  Violations violations;
  violations.requireAtLeast("a", std::nan(""), 0.0);
  violations.requireAbove("b", std::nan(""), 0.0);
  violations.requireWithin("c", std::nan(""), 0.0, 1.0);
  EXPECT_EQ(violations.sentences().size(), 3U);
}

TEST(Violations, ThrowAllAtOnce) {
  EXPECT_NO_THROW(throwIfAny({}));
  try {
    throwIfAny({"First.", "Second."});
    FAIL() << "did not throw";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "First. Second.");
  }
}

}  // namespace
}  // namespace omega_slam::geometry
