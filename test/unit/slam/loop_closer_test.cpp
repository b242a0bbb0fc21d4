#include "omega_slam/slam/loop_closer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/sensing/scan_intake.h"
#include "support/chains.h"
#include "support/keyframes.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using test::keyframeAt;

/// A hall of 12 x 4 m with things in the middle of it.
test::Room hall() {
  test::Room room;
  room.addBox({-6.0, -2.0}, {6.0, 2.0});
  room.addBox({-1.5, -2.0}, {-0.5, -1.2});
  room.addBox({0.8, 1.5}, {1.6, 2.0});
  room.addBox({-0.2, 0.9}, {0.2, 1.3});
  return room;
}

/// In the hall, and one that sees nothing behind it.
KeyframePtr lookingAheadAt(graph::NodeId id, const Pose2& T_room_base) {
  std::mt19937_64 random(id);
  auto scan = test::measure(hall(), T_room_base, 360, 0.005, random);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    if (std::cos(angle) < 0.0) {
      scan.ranges[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return std::make_shared<const Keyframe>(
      Keyframe{id, T_room_base, *sensing::ScanIntake({}).process(scan, {}).sweep});
}

constexpr double kDeviation = 0.03;  // [m], [rad] of each tie of the chain

LoopCloserConfig smallConfig() {
  LoopCloserConfig config;
  config.min_separation = 5;
  config.neighbours = 1;
  return config;
}

/// One that has the keyframes of these poses.
LoopCloser closerOf(const LoopCloserConfig& config, const std::vector<Pose2>& poses) {
  LoopCloser closer(config);
  for (graph::NodeId id = 0; id < poses.size(); ++id) {
    closer.addKeyframe(keyframeAt(id, poses[id]));
  }
  return closer;
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
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(smallConfig(), truth);
  auto believed = truth;
  believed[8] = believed[8] * Pose2{0.12, -0.1, 0.1};
  const auto loops = closer.search(8, test::chainOf(believed, kDeviation));
  ASSERT_FALSE(loops.empty());
  EXPECT_EQ(loops[0].to, 8U);
  EXPECT_EQ(loops[0].kind, graph::ConstraintKind::kLoop);
  const auto gap =
      test::gapBetween(loops[0].T_from_to, relativePose(truth[loops[0].from], truth[8]));
  EXPECT_LT(gap.translation, 0.03);
  EXPECT_LT(gap.rotation, 0.02);
}

TEST(LoopCloser, LooksWhereTheSameWasSeen) {
  LoopCloserConfig config = smallConfig();
  config.search_radius = 1.5;
  config.max_candidates = 1;
  config.neighbours = 0;
  config.place.min_confidence = 0.3;  // at the ends each sees what the other does not
  // The second stood where the robot stands now, but looked the other way.
  const std::vector<Pose2> poses{{-1.2, 0.2, 0.0},
                                 {0.0, 0.2, geometry::kPi},
                                 {-2.0, 0.2, geometry::kPi},
                                 {-3.0, 0.2, geometry::kPi},
                                 {-2.0, 0.2, 0.0},
                                 {-1.0, 0.2, 0.0},
                                 {0.0, 0.2, 0.0}};
  LoopCloser closer(config);
  for (graph::NodeId id = 0; id < poses.size(); ++id) {
    closer.addKeyframe(lookingAheadAt(id, poses[id]));
  }
  const auto loops = closer.search(6, test::chainOf(poses, kDeviation));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].from, 0U);
  const auto gap = test::gapBetween(loops[0].T_from_to, relativePose(poses[0], poses[6]));
  EXPECT_LT(gap.translation, 0.03);
  EXPECT_LT(gap.rotation, 0.02);
}

TEST(LoopCloser, LooksNeitherAtTheNewestNorBeyondTheRadius) {
  LoopCloserConfig config = smallConfig();
  config.search_radius = 0.01;
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(config, truth);
  EXPECT_TRUE(closer.search(8, test::chainOf(truth, 0.008)).empty())
      << "nothing so near but neighbours";
  EXPECT_TRUE(closer.search(4, test::chainOf(truth, 0.008)).empty()) << "nothing old enough";
}

TEST(LoopCloser, KeyframesThatHaveRetiredAreNotSearchedFor) {
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(smallConfig(), truth);
  graph::PoseGraph graph = test::chainOf(truth, kDeviation);
  const auto loops = closer.search(8, graph);
  ASSERT_FALSE(loops.empty());
  const graph::NodeId retired = loops[0].from;
  auto& ties = graph.constraints;
  ties.erase(std::remove_if(ties.begin(), ties.end(),
                            [&](const auto& c) { return c.from < retired || c.to < retired; }),
             ties.end());
  EXPECT_EQ(closer.search(8, graph).at(0).from, retired) << "those before it have retired";
  ties.erase(std::remove_if(ties.begin(), ties.end(),
                            [&](const auto& c) { return c.from == retired || c.to == retired; }),
             ties.end());
  for (const auto& loop : closer.search(8, graph)) {
    EXPECT_NE(loop.from, retired);
  }
}

TEST(LoopCloser, EachPassThatFitsTiesTheKeyframe) {
  LoopCloserConfig config = smallConfig();
  config.neighbours = 0;
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(config, truth);
  const auto loops = closer.search(8, test::chainOf(truth, kDeviation));
  ASSERT_GT(loops.size(), 1U);
  EXPECT_LE(loops.size(), static_cast<std::size_t>(config.max_candidates));
  for (const auto& loop : loops) {
    const auto gap = test::gapBetween(loop.T_from_to, relativePose(truth[loop.from], truth[8]));
    EXPECT_LT(gap.translation, 0.05);
    EXPECT_EQ(loop.to, 8U);
  }
}

TEST(LoopCloser, APlaceThatIsKnownWellNeedsNoLoop) {
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(smallConfig(), truth);
  const double well = 0.1 * smallConfig().min_deviation;  // [m], [rad] of each tie of the chain
  EXPECT_TRUE(closer.search(8, test::chainOf(truth, well)).empty());
  EXPECT_FALSE(closer.search(8, test::chainOf(truth, kDeviation)).empty());
}

/// The drift is beyond a metre, but so is what the graph admits: a first loop from so wide a window
/// waits for a second one.
TEST(LoopCloser, AWideWindowsLoopWaitsForAnotherThatAgrees) {
  LoopCloser closer(smallConfig());
  auto truth = thereAndBack();
  for (const double x : {-1.2, -1.4, -1.6, -1.8, -1.7, -1.5, -1.3, -1.1, -0.9, -0.7, -0.5}) {
    truth.push_back({x, 0.2, 0.0});
  }
  auto believed = truth;
  for (std::size_t i = 8; i < truth.size(); ++i) {
    believed[i] = Pose2{1.2, -0.5, 0.2} * truth[i];
  }
  std::vector<std::size_t> found;
  for (graph::NodeId id = 0; id < truth.size(); ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id]));
    found.push_back(closer.search(id, test::chainOf(believed, 0.3)).size());
  }
  EXPECT_EQ(found[6], 0U) << "nobody agrees yet";
  EXPECT_EQ(found[9], 0U) << "the drift came between this one and the first, so they disagree";
  EXPECT_GE(std::accumulate(found.begin() + 10, found.end(), std::size_t{0}), 2U)
      << "those that agree with one before come with it";
}

TEST(LoopCloser, APlaceIsMadeOfOneStretch) {
  const std::vector<Pose2> poses(6);
  std::vector<KeyframePtr> keyframes;
  for (graph::NodeId id = 0; id < 6; ++id) {
    keyframes.push_back(keyframeAt(id, poses[id], id < 3 ? 0 : 3));
  }
  EXPECT_EQ(placeAround(1, 2, {keyframes, poses}).size(), 3U);
  EXPECT_EQ(placeAround(3, 2, {keyframes, poses}).size(), 3U);
  EXPECT_EQ(placeAround(5, 1, {keyframes, poses}).size(), 2U);
}

/// Out of the dark, the robot looks at what it saw just before.
TEST(LoopCloser, AnotherStretchMayBeNear) {
  LoopCloser closer(smallConfig());
  const std::vector<Pose2> truth{{-1.0, 0.2, 0.0}, {-0.6, 0.2, 0.0}, {-0.5, 0.3, 0.4}};
  for (graph::NodeId id = 0; id < 3; ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id], id < 2 ? 0 : 2));
  }
  auto believed = truth;
  believed[2] = believed[2] * Pose2{0.1, -0.1, 0.08};
  const auto loops = closer.search(2, test::chainOf(believed, 0.1));
  ASSERT_FALSE(loops.empty());
  const auto gap =
      test::gapBetween(loops[0].T_from_to, relativePose(truth[loops[0].from], truth[2]));
  EXPECT_LT(gap.translation, 0.03);
}

/// Fifteen metres off, where no window is wide enough.
TEST(LoopCloser, AStretchThatIsAdriftIsFoundAnywhere) {
  LoopCloserConfig config;
  config.min_separation = 100;  // of itself it says nothing
  LoopCloser closer(config);
  std::vector<Pose2> truth;
  std::vector<Pose2> believed;
  for (int i = 0; i < 10; ++i) {
    truth.push_back({-3.0 + 0.6 * i, -1.2, 0.1 * i});
    believed.push_back(truth.back());
  }
  const auto stretch = static_cast<graph::NodeId>(truth.size());
  for (int i = 0; i < 18; ++i) {
    truth.push_back(Pose2{2.4, 0.9, 3.2} * Pose2{0.26 * i, 0.0, 0.0});
    believed.push_back(Pose2{12.0, -9.0, 2.0} * truth.back());
  }
  std::vector<graph::Constraint> loops;
  for (graph::NodeId id = 0; id < truth.size() && loops.empty(); ++id) {
    closer.addKeyframe(keyframeAt(id, truth[id], id < stretch ? 0 : stretch));
    graph::PoseGraph graph = test::chainOf(
        {believed.begin(), believed.begin() + static_cast<std::ptrdiff_t>(id) + 1}, 0.005);
    if (id >= stretch) {
      graph.constraints[stretch - 1].information = Eigen::Vector3d(0.01, 0.01, 1.0).asDiagonal();
      loops = closer.search(id, graph);
    }
  }
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_LT(loops[0].from, stretch);
  const auto gap =
      test::gapBetween(loops[0].T_from_to, relativePose(truth[loops[0].from], truth[loops[0].to]));
  EXPECT_LT(gap.translation, 0.05);
  EXPECT_LT(gap.rotation, 0.03);
}

TEST(LoopCloser, PosesThatDoNotReachTheKeyframeGiveNothing) {
  const auto truth = thereAndBack();
  LoopCloser closer = closerOf(smallConfig(), truth);
  EXPECT_TRUE(closer.search(8, test::chainOf({truth[0], truth[1]}, kDeviation)).empty());
  EXPECT_TRUE(closer.search(99, test::chainOf(truth, kDeviation)).empty());
  closer.reset();
  EXPECT_TRUE(closer.search(8, test::chainOf(truth, kDeviation)).empty());
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
