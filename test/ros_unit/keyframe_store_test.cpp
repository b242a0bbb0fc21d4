#include "nodes/common/keyframe_store.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

using Verdict = KeyframeStore::Verdict;

slam::Keyframe keyframe(graph::NodeId id) {
  slam::Keyframe result;
  result.id = id;
  return result;
}

TEST(KeyframeStore, KeyframesAndPosesMeetInAnyOrder) {
  KeyframeStore store;
  store.setPoses(5, {{}, {1.0, 0.0, 0.0}});
  EXPECT_TRUE(store.placed().empty());
  EXPECT_EQ(store.add(5, keyframe(0)), Verdict::kNewRun);
  EXPECT_EQ(store.placed().size(), 1U);
  EXPECT_EQ(store.missing(), 1U);
  EXPECT_EQ(store.add(5, keyframe(1)), Verdict::kTaken);
  EXPECT_EQ(store.add(5, keyframe(2)), Verdict::kTaken);
  const auto placed = store.placed();
  ASSERT_EQ(placed.size(), 2U) << "keyframe 2 has no pose yet";
  EXPECT_EQ(placed[1].id, 1U);
  EXPECT_EQ(placed[1].T_map_base.x, 1.0);
  EXPECT_EQ(store.missing(), 0U);
}

TEST(KeyframeStore, AKeyframeThatCameBeforeIsNotReplaced) {
  KeyframeStore store;
  store.add(5, keyframe(0));
  store.setPoses(5, {{}});
  const auto before = store.placed()[0].sweep;
  EXPECT_EQ(store.add(5, keyframe(0)), Verdict::kKnown);
  EXPECT_EQ(store.placed()[0].sweep, before);
}

TEST(KeyframeStore, OnlyKeyframeZeroEndsARun) {
  KeyframeStore store;
  EXPECT_EQ(store.add(5, keyframe(4)), Verdict::kNewRun) << "there was none before";
  EXPECT_EQ(store.add(6, keyframe(1)), Verdict::kOtherRun);
  EXPECT_EQ(store.size(), 1U);
  EXPECT_EQ(store.add(6, keyframe(0)), Verdict::kNewRun);
  EXPECT_EQ(store.size(), 1U);
}

TEST(KeyframeStore, PosesOfAnotherRunPlaceNothing) {
  KeyframeStore store;
  store.add(5, keyframe(0));
  store.setPoses(6, {{}});
  EXPECT_TRUE(store.placed().empty());
  EXPECT_EQ(store.missing(), 0U);
}

TEST(KeyframeStore, AGraphWithoutPosesForgetsItsRunAndNoOther) {
  KeyframeStore store;
  store.add(5, keyframe(0));
  store.setPoses(4, {});
  EXPECT_EQ(store.size(), 1U);
  store.setPoses(5, {});
  EXPECT_EQ(store.size(), 0U);
}

}  // namespace
}  // namespace omega_slam
