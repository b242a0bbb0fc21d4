#include "slam/crispness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace omega_slam::experiments {
namespace {

/// A wall 10 m long, 2 m to the left, with so much noise.
matching::View wallView(double noise, std::mt19937_64& random) {
  std::normal_distribution<double> error(0.0, noise);
  matching::View view;
  for (int k = 0; k < 500; ++k) {
    view.points.emplace_back(0.02 * k, 2.0 + error(random));
  }
  return view;
}

TEST(Crispness, OfOneWallIsItsNoise) {
  std::mt19937_64 random(1);
  const std::vector<matching::View> views(2, wallView(0.02, random));
  const Crispness crispness = judgeCrispness(views, {{}, {}});
  EXPECT_NEAR(crispness.wall_distance, 0.02 * std::sqrt(2.0 / M_PI), 0.003);
}

TEST(Crispness, AWallDrawnTwiceIsLessCrisp) {
  std::mt19937_64 random(1);
  const std::vector<matching::View> views{wallView(0.01, random), wallView(0.01, random)};
  const Crispness once = judgeCrispness(views, {{}, {}});
  const Crispness twice = judgeCrispness(views, {{}, {0.0, 0.1, 0.0}});
  EXPECT_NEAR(twice.wall_distance, 0.05, 0.005);
  EXPECT_GT(twice.wall_distance, 3.0 * once.wall_distance);
  EXPECT_GT(twice.entropy, once.entropy + 1.0);
}

TEST(Crispness, DoesNotDependOnWhereTheMapLies) {
  std::mt19937_64 random(1);
  const std::vector<matching::View> views{wallView(0.01, random), wallView(0.01, random)};
  const Crispness here = judgeCrispness(views, {{}, {0.0, 0.1, 0.0}});
  const geometry::Pose2 T_there_here{30.0, -20.0, 2.0};
  const Crispness there =
      judgeCrispness(views, {T_there_here, T_there_here * geometry::Pose2{0.0, 0.1, 0.0}});
  EXPECT_NEAR(here.wall_distance, there.wall_distance, 1e-9);
  EXPECT_NEAR(here.entropy, there.entropy, 1e-9);
}

TEST(Crispness, OfNothingIsZero) {
  EXPECT_EQ(judgeCrispness({}, {}).wall_distance, 0.0);
  EXPECT_EQ(judgeCrispness({matching::View{{{1.0, 1.0}}, {}}}, {{}}).wall_distance, 0.0);
}

}  // namespace
}  // namespace omega_slam::experiments
