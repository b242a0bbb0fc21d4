#include "omega_slam/slam/surroundings.h"

#include <gtest/gtest.h>

#include "support/chains.h"
#include "support/keyframes.h"
#include "support/poses.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;
using test::keyframeAt;

std::vector<Pose2> alongTheRoom(int keyframes) {
  std::vector<Pose2> poses;
  for (int i = 0; i < keyframes; ++i) {
    poses.push_back({-1.5 + 0.05 * i, 0.2, 0.0});
  }
  return poses;
}

Surroundings drawn(const std::vector<Pose2>& poses) {
  Surroundings surroundings({}, {});
  for (graph::NodeId id = 0; id < poses.size(); ++id) {
    surroundings.add(keyframeAt(id, poses[id]), poses[id]);
  }
  return surroundings;
}

TEST(Surroundings, TheNewestKeyframeIsWhereItWasTracked) {
  const auto poses = alongTheRoom(3);
  const Surroundings surroundings = drawn(poses);
  EXPECT_EQ(surroundings.newest().x, poses.back().x);
  EXPECT_EQ(surroundings.map().recentViews().size(), 3U);
}

TEST(Surroundings, AGraphThatHasNotBentMovesNothing) {
  const auto poses = alongTheRoom(5);
  Surroundings surroundings = drawn(poses);
  std::vector<Pose2> moved;
  for (const Pose2& pose : poses) {
    moved.push_back(Pose2{7.0, -3.0, 0.8} * pose);  // as one piece
  }
  const Pose2 newest = surroundings.believe(test::chainOf(moved, 0.01));
  EXPECT_EQ(newest.x, poses.back().x);
  const auto gap = test::gapBetween(surroundings.mapFromLocal() * newest, moved.back());
  EXPECT_LT(gap.translation, 1e-9);
  EXPECT_LT(gap.rotation, 1e-9);
}

TEST(Surroundings, AGraphThatHasBentIsDrawnAnewInItsFrame) {
  const auto poses = alongTheRoom(5);
  Surroundings surroundings = drawn(poses);
  auto bent = poses;
  bent[0] = Pose2{0.0, 0.3, 0.1} * bent[0];
  const Pose2 newest = surroundings.believe(test::chainOf(bent, 0.01));
  EXPECT_EQ(newest.x, bent.back().x);
  EXPECT_EQ(surroundings.mapFromLocal().x, 0.0);
}

TEST(Surroundings, KeyframesThatTheGraphDoesNotKnowYetGoWithTheNewestThatItKnows) {
  const auto poses = alongTheRoom(6);
  Surroundings surroundings = drawn(poses);
  auto bent = poses;
  bent.resize(5);
  const Pose2 shift{0.5, 0.2, 0.3};
  for (graph::NodeId id = 1; id < 5; ++id) {
    bent[id] = shift * bent[id];
  }
  const Pose2 newest = surroundings.believe(test::chainOf(bent, 0.01));
  const auto gap = test::gapBetween(newest, shift * poses[5]);
  EXPECT_LT(gap.translation, 1e-9);
  EXPECT_LT(gap.rotation, 1e-9);
}

TEST(Surroundings, AnEarlierPassComesInOnceItIsKnownWell) {
  // Up and down the room, with ties so loose that the first keyframes are not known from the last.
  auto poses = alongTheRoom(30);
  Surroundings surroundings = drawn(poses);
  graph::PoseGraph graph = test::chainOf(poses, 0.05);
  graph.poses[28].y += 0.2;  // bent, so that all is drawn anew
  (void)surroundings.believe(graph);
  EXPECT_FALSE(surroundings.isDrawn(0));
  EXPECT_TRUE(surroundings.isDrawn(29));
  graph::Constraint loop;
  loop.from = 0;
  loop.to = 29;
  loop.T_from_to = relativePose(graph.poses[0], graph.poses[29]);
  loop.information = Eigen::Matrix3d::Identity() / (0.01 * 0.01);
  graph.constraints.push_back(loop);
  (void)surroundings.believe(graph);
  EXPECT_TRUE(surroundings.isDrawn(0));
}

TEST(Surroundings, AStretchBeforeComesInOnceItIsKnownWell) {
  const auto poses = alongTheRoom(6);
  Surroundings surroundings({}, {});
  for (graph::NodeId id = 0; id < 3; ++id) {
    surroundings.add(keyframeAt(id, poses[id]), poses[id]);
  }
  surroundings.leave();
  EXPECT_FALSE(surroundings.isDrawn(2));
  for (graph::NodeId id = 3; id < 6; ++id) {
    surroundings.add(keyframeAt(id, poses[id], 3), poses[id]);
  }
  graph::PoseGraph graph = test::chainOf(poses, 0.01);
  graph.constraints[2].information = Eigen::Matrix3d::Identity();  // a metre, a radian
  (void)surroundings.believe(graph);
  EXPECT_FALSE(surroundings.isDrawn(2));
  EXPECT_EQ(surroundings.map().recentViews().size(), 3U);
  graph.constraints[2].information *= 1e4;
  (void)surroundings.believe(graph);
  EXPECT_TRUE(surroundings.isDrawn(2));
}

TEST(Surroundings, AnEarlierPlaceIsDrawnWithItsStretchAlone) {
  const auto poses = alongTheRoom(9);
  Surroundings surroundings({}, {});
  for (graph::NodeId id = 0; id < 9; ++id) {
    surroundings.add(keyframeAt(id, poses[id], id - id % 3), poses[id]);
  }
  (void)surroundings.believe(test::chainOf(poses, 0.01));
  surroundings.moveTo(4);
  for (graph::NodeId id = 0; id < 9; ++id) {
    EXPECT_EQ(surroundings.isDrawn(id), id >= 3 && id < 6) << id;
  }
}

TEST(Surroundings, ConfigurationIsChecked) {
  SurroundingsConfig config;
  config.radius = 0.0;
  config.max_keyframes = 0;
  EXPECT_EQ(config.validate().size(), 2U);
  EXPECT_THROW(Surroundings(config, {}), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::slam
