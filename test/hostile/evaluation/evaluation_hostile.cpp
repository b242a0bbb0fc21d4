#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/evaluation/report.h"
#include "omega_slam/evaluation/trajectory_error.h"

namespace omega_slam::evaluation {
namespace {

TEST(EvaluationHostile, StampsThatRepeatOrGoBack) {
  const geometry::Trajectory odd{
      {1.0, {0, 0, 0}}, {1.0, {0, 0, 0}}, {0.5, {0, 0, 0}}, {3.0, {2, 0, 0}}};
  const RelationsScore score = scoreRelations(odd, {{1.0, 2.0, {1, 0, 0}}, {1.0, 1.0, {}}});
  EXPECT_EQ(score.covered, 2U);
  EXPECT_NEAR(score.translation.max, 0.0, 1e-12);
  const TrajectoryError error = absoluteTrajectoryError(odd, odd, 5.0);
  EXPECT_EQ(error.matched, 4U);
  EXPECT_NEAR(error.translation.max, 0.0, 1e-12);
}

TEST(EvaluationHostile, StampsThatAreNoNumbersAreNotCovered) {
  const geometry::Trajectory drive{{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}};
  const double nan = std::nan("");
  EXPECT_EQ(scoreRelations(drive, {{nan, 1.0, {}}, {0.0, nan, {}}}).covered, 0U);
}

TEST(EvaluationHostile, OptionsAreChecked) {
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    RelationsOptions options;
    options.tolerance = bad;
    EXPECT_THROW(static_cast<void>(scoreRelations({}, {}, {}, options)), std::invalid_argument);
    options = {};
    options.max_gap = bad;
    EXPECT_THROW(static_cast<void>(scoreRelations({}, {}, {}, options)), std::invalid_argument);
  }
}

TEST(EvaluationHostile, OnePoseIsAlignedByItsHeading) {
  const TrajectoryError error =
      absoluteTrajectoryError({{1.0, {1, 2, 0.5}}}, {{1.0, {-1, 0, -0.5}}});
  EXPECT_EQ(error.matched, 1U);
  EXPECT_NEAR(error.translation.max, 0.0, 1e-12);
  EXPECT_NEAR(error.rotation.max, 0.0, 1e-12);
  EXPECT_NEAR(error.T_truth_map.theta, -1.0, 1e-12);
}

TEST(EvaluationHostile, ReportsOfNames) {
  Report report;
  report.input = "a|b\n\"c\" \\";
  report.notes = {""};
  EXPECT_FALSE(toJson(report).empty());
  EXPECT_FALSE(toMarkdown(report).empty());
}

}  // namespace
}  // namespace omega_slam::evaluation
