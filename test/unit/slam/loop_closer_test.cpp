#include "omega_slam/slam/loop_closer.h"

#include <gtest/gtest.h>

#include "omega_slam/sensing/scan_intake.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

KeyframePtr keyframeAt(graph::NodeId id, const Pose2& T_room_base) {
  std::mt19937_64 random(id);
  const auto scan = test::measure(test::furnishedRoom(), T_room_base, 360, 0.005, random);
  return std::make_shared<const Keyframe>(
      Keyframe{id, T_room_base, *sensing::ScanIntake({}).process(scan, {}).sweep});
}

LoopCloserConfig smallConfig() {
  LoopCloserConfig config;
  config.min_separation = 5;
  config.neighbours = 1;
  return config;
}

/// Along the room and back to the start; the last pose is believed to be off.
std::vector<Pose2> thereAndBack() {
  std::vector<Pose2> poses;
  for (const double x : {-1.0, -0.6, -0.2, 0.2, 0.6, 0.3, -0.1, -0.5, -0.9}) {
    poses.push_back({x, 0.2, 0.0});
  }
  return poses;
}

TEST(LoopCloser, FindsTheFirstVisitFromAPoorGuess) {
  LoopCloser closer(smallConfig());
  const auto truth = thereAndBack();
  for (graph::NodeId id = 0; id < truth.size(); ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id]));
  }
  auto believed = truth;
  believed[8] = believed[8] * Pose2{0.12, -0.1, 0.1};
  const auto loops = closer.search(8, believed);
  ASSERT_FALSE(loops.empty());
  EXPECT_EQ(loops[0].to, 8U);
  EXPECT_EQ(loops[0].kind, graph::ConstraintKind::kLoop);
  const auto gap =
      test::gapBetween(loops[0].T_from_to, relativePose(truth[loops[0].from], truth[8]));
  EXPECT_LT(gap.translation, 0.03);
  EXPECT_LT(gap.rotation, 0.02);
}

TEST(LoopCloser, LooksNeitherAtTheNewestNorBeyondTheRadius) {
  LoopCloserConfig config = smallConfig();
  config.search_radius = 0.05;
  LoopCloser closer(config);
  const auto truth = thereAndBack();
  for (graph::NodeId id = 0; id < truth.size(); ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id]));
  }
  EXPECT_TRUE(closer.search(8, truth).empty()) << "nothing within 5 cm but neighbours";
  EXPECT_TRUE(closer.search(4, truth).empty()) << "nothing old enough";
}

TEST(LoopCloser, PosesThatDoNotReachTheKeyframeGiveNothing) {
  LoopCloser closer(smallConfig());
  const auto truth = thereAndBack();
  for (graph::NodeId id = 0; id < truth.size(); ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id]));
  }
  EXPECT_TRUE(closer.search(8, {truth[0], truth[1]}).empty());
  EXPECT_TRUE(closer.search(99, truth).empty());
  closer.reset();
  EXPECT_TRUE(closer.search(8, truth).empty());
}

TEST(LoopCloser, ConfigurationIsChecked) {
  LoopCloserConfig config;
  config.search_radius = 0.0;
  config.min_separation = 0;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(LoopCloser{config}, std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::slam
