#include "nodes/common/loop_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

#include "support/chains.h"

namespace omega_slam {
namespace {

using geometry::Pose2;
using std::chrono::seconds;

constexpr std::size_t kKeyframes = 6;

/// All keyframes are taken at one place in one room of uneven walls.
slam::KeyframePtr keyframe(graph::NodeId id) {
  slam::Keyframe result;
  result.id = id;
  result.sweep.angle_increment = 0.02;
  for (int i = 0; i < 314; ++i) {
    const double angle = 0.02 * i;
    const double range = std::min({3.0 / std::max(1e-9, std::abs(std::cos(angle))),
                                   2.0 / std::max(1e-9, std::abs(std::sin(angle))), 3.4});
    result.sweep.beams.push_back(
        {range * Eigen::Vector2d(std::cos(angle), std::sin(angle)), sensing::BeamKind::kReturn});
  }
  return std::make_shared<const slam::Keyframe>(std::move(result));
}

/// All believed to be at one place, though none is sure of it.
graph::PoseGraph graphOf(std::size_t keyframes) {
  return test::chainOf(std::vector<Pose2>(keyframes), 0.03);
}

slam::LoopCloserConfig config() {
  slam::LoopCloserConfig result;
  result.min_separation = 3;
  return result;
}

class LoopSearchTest : public ::testing::Test {
 protected:
  LoopSearch::Found take() {
    return [this](const std::vector<graph::Constraint>& constraints, std::uint64_t run) {
      const std::lock_guard<std::mutex> lock(mutex_);
      runs_.push_back(run);
      constraints_.insert(constraints_.end(), constraints.begin(), constraints.end());
      told_.notify_all();
    };
  }
  [[nodiscard]] bool waitForCalls(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    return told_.wait_for(lock, seconds(30), [&] { return runs_.size() >= count; });
  }

  std::mutex mutex_;
  std::condition_variable told_;
  std::vector<std::uint64_t> runs_;
  std::vector<graph::Constraint> constraints_;
};

TEST_F(LoopSearchTest, EachKeyframeIsSearchedOnceAsSoonAsItHasAPose) {
  LoopSearch search(config(), 1, take());
  for (graph::NodeId id = 0; id < kKeyframes; ++id) {
    search.addKeyframe(keyframe(id));
  }
  search.setGraph(graphOf(2));
  ASSERT_TRUE(waitForCalls(2));
  search.setGraph(graphOf(kKeyframes));
  ASSERT_TRUE(waitForCalls(kKeyframes));
  search.setGraph(graphOf(kKeyframes));
  search.stop();
  EXPECT_EQ(runs_.size(), kKeyframes);
  EXPECT_EQ(search.searched(), kKeyframes);
  EXPECT_EQ(search.found(), constraints_.size());
  ASSERT_FALSE(constraints_.empty());
  for (const graph::Constraint& loop : constraints_) {
    EXPECT_EQ(loop.kind, graph::ConstraintKind::kLoop);
    EXPECT_GE(std::max(loop.from, loop.to) - std::min(loop.from, loop.to), 3U);
  }
}

TEST_F(LoopSearchTest, AResetForgetsTheKeyframesOfTheRunBefore) {
  LoopSearch search(config(), 1, take());
  for (graph::NodeId id = 0; id < kKeyframes; ++id) {
    search.addKeyframe(keyframe(id));
  }
  search.setGraph(graphOf(kKeyframes));
  ASSERT_TRUE(waitForCalls(kKeyframes));
  search.reset(2);
  EXPECT_EQ(search.searched(), 0U);
  search.addKeyframe(keyframe(0));
  search.setGraph(graphOf(1));
  ASSERT_TRUE(waitForCalls(kKeyframes + 1));
  search.stop();
  EXPECT_EQ(runs_.back(), 2U);
  EXPECT_EQ(search.searched(), 1U);
}

TEST_F(LoopSearchTest, PosesMayComeFromOneThreadAndRunsFromAnother) {
  constexpr std::uint64_t kRuns = 4;
  LoopSearch search(config(), 1, take());
  std::atomic<bool> is_over{false};
  std::thread poses([&] {
    while (!is_over) {
      search.setGraph(graphOf(kKeyframes));
      EXPECT_LE(search.searched(), kKeyframes);
      std::this_thread::yield();
    }
  });
  for (std::uint64_t run = 1; run <= kRuns; ++run) {
    search.reset(run);
    for (graph::NodeId id = 0; id < kKeyframes; ++id) {
      search.addKeyframe(keyframe(id));
    }
  }
  {
    std::unique_lock<std::mutex> lock(mutex_);
    EXPECT_TRUE(told_.wait_for(lock, seconds(30), [&] {
      return std::count(runs_.begin(), runs_.end(), kRuns) == std::ptrdiff_t{kKeyframes};
    }));
  }
  is_over = true;
  poses.join();
  search.stop();
  EXPECT_EQ(search.searched(), kKeyframes);
}

TEST_F(LoopSearchTest, ItEndsWhileThereIsWorkLeft) {
  LoopSearch search(config(), 1, take());
  for (graph::NodeId id = 0; id < 200; ++id) {
    search.addKeyframe(keyframe(id));
  }
  search.setGraph(graphOf(200));
  search.stop();
  EXPECT_LT(search.searched(), 200U);
}

}  // namespace
}  // namespace omega_slam
