#include "omega_slam/slam/relocaliser.h"

#include <gtest/gtest.h>

#include "omega_slam/sensing/scan_intake.h"
#include "support/poses.h"
#include "support/room.h"

namespace omega_slam::slam {
namespace {

using geometry::Pose2;

sensing::Sweep sweepAt(const Pose2& T_room_base, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto scan = test::measure(test::furnishedRoom(), T_room_base, 360, 0.01, random);
  return *sensing::ScanIntake({}).process(scan, {}).sweep;
}

/// Keyframes along the room.
class RelocaliserTest : public ::testing::Test {
 protected:
  RelocaliserTest() {
    for (graph::NodeId id = 0; id < 10; ++id) {
      const Pose2 pose{-3.0 + 0.6 * id, -1.2, 0.1 * id};
      keyframes_.push_back(std::make_shared<const Keyframe>(Keyframe{id, pose, sweepAt(pose, id)}));
      poses_.push_back(pose);
    }
  }

  /// Looks once from each place along a way.
  /// @return the looks that it took; 0 if none was enough
  int looksUntilFound(const std::vector<Pose2>& way) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      found_ = relocaliser_.look(viewOf(sweepAt(way[i], 100 + i)),
                                 relativePose(way.front(), way[i]), {keyframes_, poses_});
      if (found_) {
        truth_ = way[i];
        return static_cast<int>(i) + 1;
      }
    }
    return 0;
  }

  std::vector<KeyframePtr> keyframes_;
  std::vector<Pose2> poses_;
  Relocaliser relocaliser_{{}};
  std::optional<Relocation> found_;
  Pose2 truth_;
};

std::vector<Pose2> along(const Pose2& start, double step, int count) {
  std::vector<Pose2> way;
  for (int i = 0; i < count; ++i) {
    way.push_back(start * Pose2{step * i, 0.0, 0.0});
  }
  return way;
}

constexpr double kStep = 0.25;  // [m]
const Pose2 kSetDown{2.4, 0.9, 3.2};

TEST_F(RelocaliserTest, FindsARobotThatIsAnywhereAndLooksAnywhere) {
  const int looks = looksUntilFound(along(kSetDown, kStep, 18));
  ASSERT_GT(looks * kStep, 3.0) << "one fit is not enough";
  const Pose2 pose = poses_[found_->keyframe] * found_->match.T_reference_scan;
  EXPECT_LT(test::gapBetween(pose, truth_).translation, 0.05);
  EXPECT_LT(test::gapBetween(pose, truth_).rotation, 0.03);
}

TEST_F(RelocaliserTest, DoesNotChooseBetweenRoomsThatLookAlike) {
  const std::size_t rooms = poses_.size();
  for (std::size_t k = 0; k < rooms; ++k) {
    keyframes_.push_back(keyframes_[k]);
    poses_.push_back(Pose2{30.0, 0.0, 0.0} * poses_[k]);
  }
  EXPECT_EQ(looksUntilFound(along(kSetDown, kStep, 18)), 0);
}

TEST_F(RelocaliserTest, BeginsAnewAfterARest) {
  const auto way = along(kSetDown, kStep, 18);
  const auto half = way.begin() + 9;
  EXPECT_EQ(looksUntilFound({way.begin(), half}), 0);
  relocaliser_.rest();
  EXPECT_EQ(looksUntilFound({half, way.end()}), 0) << "what was confirmed before does not count";
}

TEST_F(RelocaliserTest, WaitsUntilTheRobotHasMovedOn) {
  EXPECT_EQ(looksUntilFound(along(kSetDown, 0.0, 30)), 0);
}

TEST_F(RelocaliserTest, KnowsNoPlaceWithoutAGraph) {
  poses_.clear();
  EXPECT_EQ(looksUntilFound(along(kSetDown, kStep, 10)), 0);
}

TEST_F(RelocaliserTest, DoesNotFindWhatIsElsewhere) {
  std::mt19937_64 random(5);
  test::Room other;
  other.addBox({-1.0, -4.0}, {6.0, 2.0});
  other.walls.push_back({{2.0, -4.0}, {3.0, -1.0}});
  for (int i = 0; i < 20; ++i) {
    const Pose2 pose{0.1 * i, 0.0, 0.0};
    const auto scan = test::measure(other, pose, 360, 0.01, random);
    const auto view = viewOf(*sensing::ScanIntake({}).process(scan, {}).sweep);
    EXPECT_FALSE(relocaliser_.look(view, pose, {keyframes_, poses_})) << i;
  }
}

}  // namespace
}  // namespace omega_slam::slam
