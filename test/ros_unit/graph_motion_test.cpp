#include "nodes/common/graph_motion.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

TEST(GraphMotion, LeadsFromOneGraphToTheNextOfItsRun) {
  GraphMotion motion;
  EXPECT_FALSE(motion.take(7, {{0.0, 0.0, 0.0}}));
  const auto moved = motion.take(7, {{1.0, 0.5, 0.0}, {9.0, 9.0, 0.0}});
  ASSERT_TRUE(moved);
  EXPECT_TRUE(moved->apply(Eigen::Vector2d(2.0, 0.0)).isApprox(Eigen::Vector2d(3.0, 0.5)));
  const auto again = motion.take(7, {{1.0, 0.5, 0.0}, {9.0, 8.0, 0.0}});
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->apply(Eigen::Vector2d(9.0, 9.0)).isApprox(Eigen::Vector2d(9.0, 8.0)));
}

TEST(GraphMotion, AnotherRunHasAnotherMap) {
  GraphMotion motion;
  (void)motion.take(7, {{0.0, 0.0, 0.0}});
  EXPECT_FALSE(motion.take(8, {{1.0, 0.0, 0.0}}));
  EXPECT_TRUE(motion.take(8, {{1.0, 0.0, 0.0}}));
}

TEST(GraphMotion, NothingMovesWithAGraphWithoutPoses) {
  GraphMotion motion;
  (void)motion.take(7, {{0.0, 0.0, 0.0}});
  const auto moved = motion.take(7, {});
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->apply(Eigen::Vector2d(2.0, 0.0)), Eigen::Vector2d(2.0, 0.0));
}

}  // namespace
}  // namespace omega_slam
