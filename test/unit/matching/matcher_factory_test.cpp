#include "omega_slam/matching/matcher_factory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;
using testing::Contains;
using testing::HasSubstr;

TEST(MatcherFactory, EveryNameMakesAMatcherThatMatches) {
  std::mt19937_64 random(1);
  const View reference{test::measurePoints(test::furnishedRoom(), {}, 360, 0.01, random)};
  const Pose2 truth{0.1, -0.05, 0.05};
  const View scan{test::measurePoints(test::furnishedRoom(), truth, 360, 0.01, random)};
  for (const std::string& name : matcherNames()) {
    SCOPED_TRACE(name);
    MatcherConfig config;
    config.matcher = name;
    const auto result = makeMatcher(config)->match({reference}, scan, {});
    const auto gap = test::gapBetween(result.T_reference_scan, truth);
    EXPECT_LT(gap.translation, 0.03);
    EXPECT_LT(gap.rotation, 0.01);
    EXPECT_EQ(result.failure, MatchFailure::kNone);
  }
}

TEST(MatcherFactory, NamesAreTheOnesThatConfigurationsUse) {
  for (const auto* name :
       {"correlative", "hill_climbing", "icp", "particles", "point_to_line", "scan_to_map"}) {
    EXPECT_THAT(matcherNames(), Contains(name));
  }
}

TEST(MatcherFactory, MakesTheOneThatIsNamed) {
  MatcherConfig config;
  config.particles.max_near_share = 0.0;
  config.particles.near_range = 100.0;
  std::mt19937_64 random(1);
  const View room{test::measurePoints(test::furnishedRoom(), {}, 360, 0.01, random)};
  config.matcher = "particles";  // the only one that minds what is near
  EXPECT_EQ(makeMatcher(config)->match({room}, room, {}).failure, MatchFailure::kTooManyNear);
  config.matcher = "hill_climbing";
  config.hill_climbing.rounds = 0;  // and this one finds nothing then
  EXPECT_EQ(makeMatcher(config)->match({room}, room, {}).failure, MatchFailure::kNotConverged);
  config.matcher = "correlative";
  config.correlative.max_refinements = 0;  // and this one does not refine
  EXPECT_EQ(makeMatcher(config)->match({room}, room, {}).failure, MatchFailure::kNotConverged);
  config.matcher = "icp";
  EXPECT_EQ(makeMatcher(config)->match({room}, room, {}).failure, MatchFailure::kNone);
}

TEST(MatcherFactory, ScanToMapIsSearchedForWhereItIsLost) {
  MatcherConfig config;
  config.matcher = "scan_to_map";
  config.correlative.window = {1.0, 0.6};
  std::mt19937_64 random(1);
  const View room{test::measurePoints(test::furnishedRoom(), {}, 360, 0.01, random)};
  const Pose2 guess{0.8, -0.5, 0.5};
  const auto found = makeMatcher(config)->match({room}, room, guess);
  EXPECT_LT(test::gapBetween(found.T_reference_scan, {}).translation, 0.02);
  config.scan_to_map.min_confidence = 0.0;  // never lost
  const auto lost = makeMatcher(config)->match({room}, room, guess);
  EXPECT_GT(test::gapBetween(lost.T_reference_scan, {}).translation, 0.3);
}

TEST(MatcherFactory, FaultsOfEveryGroupAreFound) {
  MatcherConfig config;
  config.matcher = "icq";
  config.match.min_returns = 0;
  config.correlative.resolution = 0.0;
  config.hill_climbing.rounds = -1;
  config.icp.max_correspondence_distance = -1.0;
  config.particles.space = "polar";
  config.point_to_line.max_iterations = -1;
  config.scan_to_map.map.levels = 0;
  const auto sentences = config.validate();
  EXPECT_THAT(sentences, Contains(HasSubstr("\"icq\"")));
  EXPECT_THAT(sentences, Contains(HasSubstr("match/min_returns")));
  EXPECT_THAT(sentences, Contains(HasSubstr("correlative/resolution")));
  EXPECT_THAT(sentences, Contains(HasSubstr("hill_climbing/rounds")));
  EXPECT_THAT(sentences, Contains(HasSubstr("icp/max_correspondence_distance")));
  EXPECT_THAT(sentences, Contains(HasSubstr("particles/space")));
  EXPECT_THAT(sentences, Contains(HasSubstr("point_to_line/max_iterations")));
  EXPECT_THAT(sentences, Contains(HasSubstr("scan_to_map/map/levels")));
  EXPECT_THROW((void)makeMatcher(config), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::matching
