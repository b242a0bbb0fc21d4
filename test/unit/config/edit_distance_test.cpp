#include "omega_slam/config/edit_distance.h"

#include <gtest/gtest.h>

namespace omega_slam::config {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);  // Levenshtein's textbook example
  EXPECT_EQ(editDistance("seed", "seed"), 0U);
  EXPECT_EQ(editDistance("seed", "sed"), 1U);
  EXPECT_EQ(editDistance("sede", "seed"), 2U);
}

TEST(EditDistance, OfTheEmptyWordIsTheLengthOfTheOther) {
  EXPECT_EQ(editDistance("", "range"), 5U);
  EXPECT_EQ(editDistance("range", ""), 5U);
  EXPECT_EQ(editDistance("", ""), 0U);
}

TEST(EditDistance, NearestWordIsTheFirstOfEquals) {
  EXPECT_EQ(nearestWord("rnge", {"angle", "range", "orange"}), "range");
  EXPECT_EQ(nearestWord("b", {"a", "c"}), "a");
  EXPECT_EQ(nearestWord("b", {}), "");
}

}  // namespace
}  // namespace omega_slam::config
