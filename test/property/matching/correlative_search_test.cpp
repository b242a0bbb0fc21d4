#include "omega_slam/matching/correlative_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr CorrelativeSearchConfig kCoarse{{0.22, 0.12}, 0.04, 0.2};

/// A room seen from two places, and where the search believes the second to be.
struct Scene {
  Points reference;
  Points scan;
  Pose2 truth;
  Pose2 guess;
};

Scene randomScene(std::mt19937_64& random, int beams = 40) {
  Scene scene;
  const Pose2 place = test::randomPose(0.8, 3.1, random);
  scene.truth = test::randomPose(0.3, 0.5, random);
  scene.reference = test::measurePoints(test::furnishedRoom(), place, 3 * beams, 0.01, random);
  scene.scan = test::measurePoints(test::furnishedRoom(), place * scene.truth, beams, 0.01, random);
  scene.guess =
      Pose2::fromVector(scene.truth.vector() + test::randomPose(0.2, 0.1, random).vector());
  return scene;
}

/// Every pose of a block that is in the lattice.
template <class Visitor>
void forEachPose(const PoseLattice& lattice, const PoseBlock& block, const Visitor& visit) {
  const int side = 1 << block.level;
  for (int a = block.a; a < std::min(block.a + side, 2 * lattice.turns + 1); ++a) {
    for (int y = block.y; y < std::min(block.y + side, 2 * lattice.steps + 1); ++y) {
      for (int x = block.x; x < std::min(block.x + side, 2 * lattice.steps + 1); ++x) {
        visit(PoseBlock{0, x, y, a});
      }
    }
  }
}

constexpr PoseBlock kEverything{16, 0, 0, 0};

TEST(CorrelativeSearchLaws, FindsWhatTryingEveryPoseFinds) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 4; ++i) {
      const Scene scene = randomScene(random);
      const CorrelativeSearch search(scene.reference, scene.scan, scene.guess, kCoarse);
      int best = 0;
      Pose2 best_pose;
      forEachPose(search.lattice(), kEverything, [&](const PoseBlock& pose) {
        const int score = search.bound(pose);
        if (score > best) {
          best = score;
          best_pose = search.lattice().poseAt(pose.x, pose.y, pose.a);
        }
      });
      const auto peaks = search.peaks(1);
      ASSERT_EQ(peaks.size(), 1U);
      const auto gap = test::gapBetween(peaks[0].T_reference_scan, best_pose);
      EXPECT_LT(gap.translation, 1e-9) << i;
      EXPECT_LT(gap.rotation, 1e-9) << i;
    }
  }
}

/// A guess at a heading that lays a point of the scan near a place.
Pose2 guessNear(const Eigen::Vector2d& place, const Eigen::Vector2d& point, double heading) {
  const Eigen::Vector2d origin = place - Pose2{0.0, 0.0, heading} * point;
  return {origin.x() + 0.3, origin.y() - 0.2, heading};
}

/// Draws blocks of all levels and counts those with a bound below the full score.
int checkBounds(const CorrelativeSearch& search, int blocks, int full, std::mt19937_64& random) {
  const PoseLattice& lattice = search.lattice();
  std::uniform_int_distribution<int> place(0, 2 * lattice.steps);
  std::uniform_int_distribution<int> heading(0, 2 * lattice.turns);
  int tight = 0;
  for (int level = 0; level < search.levels(); ++level) {
    for (int i = 0; i < blocks; ++i) {
      const auto corner = [&](int index) { return index >> level << level; };
      const PoseBlock block{level, corner(place(random)), corner(place(random)),
                            corner(heading(random))};
      const int bound = search.bound(block);
      int best = std::numeric_limits<int>::min();
      forEachPose(lattice, block,
                  [&](const PoseBlock& pose) { best = std::max(best, search.bound(pose)); });
      EXPECT_GE(bound, best) << "level " << level;
      tight += bound < full ? 1 : 0;
    }
  }
  return tight;
}

TEST(CorrelativeSearchLaws, NoPoseOfABlockScoresMoreThanItsBound) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = randomScene(random);
    // A window of many blocks on all levels.
    constexpr CorrelativeSearchConfig kWide{{0.8, 0.3}, 0.04, 0.2};
    const auto full = LikelihoodPyramid::kFull * static_cast<int>(scene.scan.size());
    const CorrelativeSearch search(scene.reference, scene.scan, scene.guess, kWide);
    ASSERT_GE(search.levels(), 4);
    EXPECT_GT(checkBounds(search, 10, full, random), 5 * search.levels())
        << "a bound that allows everything is no bound";
    // Where points are many, one that is too low hides behind others that are too high.
    const Eigen::Vector2d& surface = scene.reference.front();
    for (std::size_t i = 0; i < scene.scan.size(); i += 4) {
      const Eigen::Vector2d& point = scene.scan[i];
      const Pose2 guess = guessNear(surface, point, scene.guess.theta);
      (void)checkBounds({{surface}, {point}, guess, kWide}, 5, full, random);
    }
  }
}

TEST(CorrelativeSearchLaws, ScoreIsTheMeanLikelihoodOfThePoints) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = randomScene(random);
    constexpr CorrelativeSearchConfig kFine{{0.1, 0.1}, 0.002, 0.2};
    const CorrelativeSearch search(scene.reference, scene.scan, scene.guess, kFine);
    for (int i = 0; i < 20; ++i) {
      const Pose2 pose = scene.truth * test::randomPose(0.2, 0.1, random);
      double sum = 0.0;
      for (const Eigen::Vector2d& point : scene.scan) {
        double nearest = kFine.reach * kFine.reach;
        for (const Eigen::Vector2d& surface : scene.reference) {
          nearest = std::min(nearest, (pose * point - surface).squaredNorm());
        }
        sum += 1.0 - nearest / (kFine.reach * kFine.reach);
      }
      EXPECT_NEAR(search.score(pose), sum / static_cast<double>(scene.scan.size()), 0.01);
    }
  }
}

TEST(CorrelativeSearchLaws, FindsThePlaceFromAnywhereInAWideWindow) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 5; ++i) {
      Scene scene = randomScene(random, 120);
      scene.guess =
          Pose2::fromVector(scene.truth.vector() + test::randomPose(1.5, 3.1, random).vector());
      const CorrelativeSearch search(scene.reference, scene.scan, scene.guess,
                                     {{1.5, geometry::kPi}, 0.02, 0.1});
      const auto peaks = search.peaks(1);
      ASSERT_EQ(peaks.size(), 1U);
      const auto gap = test::gapBetween(peaks[0].T_reference_scan, scene.truth);
      EXPECT_LT(gap.translation, 0.08) << i;
      EXPECT_LT(gap.rotation, 0.03) << i;
    }
  }
}

TEST(CorrelativeSearchLaws, PeaksAreApartAndInOrder) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = randomScene(random);
    const CorrelativeSearch search(scene.reference, scene.scan, scene.guess,
                                   {{0.4, 0.2}, 0.04, 0.2});
    const SearchWindow apart{0.2, 0.1};
    const auto peaks = search.peaks(3, apart);
    ASSERT_EQ(peaks.size(), 3U);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Pose2& a = peaks[i].T_reference_scan;
        const Pose2& b = peaks[k].T_reference_scan;
        EXPECT_TRUE(std::abs(a.x - b.x) > apart.translation ||
                    std::abs(a.y - b.y) > apart.translation ||
                    std::abs(geometry::angleDifference(a.theta, b.theta)) > apart.rotation);
        EXPECT_LT(peaks[i].score, peaks[k].score + 0.1) << "but for what nearness is worth";
      }
    }
  }
}

TEST(CorrelativeSearchLaws, RivalsOfASmallerShareAreLeftOut) {
  constexpr double kShare = 0.6;
  constexpr double kWorthOfNearness = 0.04;
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Scene scene = randomScene(random);
    CorrelativeSearchConfig config{{0.4, 0.2}, 0.04, 0.2};
    const SearchWindow apart{0.1, 0.05};
    const auto all =
        CorrelativeSearch(scene.reference, scene.scan, scene.guess, config).peaks(8, apart);
    config.least_rival = kShare;
    const auto rivals =
        CorrelativeSearch(scene.reference, scene.scan, scene.guess, config).peaks(8, apart);
    ASSERT_FALSE(rivals.empty());
    ASSERT_LE(rivals.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i < rivals.size()) {
        EXPECT_EQ(rivals[i].score, all[i].score) << i;
        EXPECT_GT(rivals[i].score, kShare * all[0].score - 1e-9) << i;
      } else {
        EXPECT_LE(all[i].score, kShare * all[0].score + kWorthOfNearness) << i;
      }
    }
  }
}

TEST(CorrelativeSearchLaws, SecondPeakIsTheBestBeyondTheFirst) {
  std::mt19937_64 random(4);
  const Scene scene = randomScene(random);
  const CorrelativeSearch search(scene.reference, scene.scan, scene.guess, kCoarse);
  const SearchWindow apart{0.12, 0.08};
  const auto peaks = search.peaks(2, apart);
  ASSERT_EQ(peaks.size(), 2U);
  int best = 0;
  Pose2 best_pose;
  forEachPose(search.lattice(), kEverything, [&](const PoseBlock& index) {
    const Pose2 pose = search.lattice().poseAt(index.x, index.y, index.a);
    const Pose2& first = peaks[0].T_reference_scan;
    const double turn = std::abs(geometry::angleDifference(pose.theta, first.theta));
    constexpr double kMargin = 1e-6;
    const int turns = static_cast<int>(std::ceil(apart.rotation / search.lattice().turn));
    const bool is_near = std::abs(pose.x - first.x) < apart.translation + kMargin &&
                         std::abs(pose.y - first.y) < apart.translation + kMargin &&
                         turn < turns * search.lattice().turn + kMargin;
    const int score = search.bound(index);
    if (!is_near && score > best) {
      best = score;
      best_pose = pose;
    }
  });
  const auto gap = test::gapBetween(peaks[1].T_reference_scan, best_pose);
  EXPECT_LT(gap.translation, 1e-9);
  EXPECT_LT(gap.rotation, 1e-9);
}

TEST(CorrelativeSearchLaws, AmongEqualsTheNearestToTheGuessWins) {
  Points walls;  // a corridor without ends
  for (int i = -500; i <= 500; ++i) {
    walls.emplace_back(0.02 * i, -1.0);
    walls.emplace_back(0.02 * i, 1.0);
  }
  Points scan;
  for (int i = -20; i <= 20; ++i) {
    scan.emplace_back(0.1 * i, -1.0);
    scan.emplace_back(0.1 * i, 1.0);
  }
  for (const double x : {-0.33, 0.0, 0.21}) {
    const CorrelativeSearch search(walls, scan, {x, 0.1, 0.05}, {{0.4, 0.1}, 0.02, 0.1});
    const auto peaks = search.peaks(1);
    ASSERT_EQ(peaks.size(), 1U);
    EXPECT_NEAR(peaks[0].T_reference_scan.x, x, 0.021);
    EXPECT_NEAR(peaks[0].T_reference_scan.y, 0.0, 0.021);
  }
}

}  // namespace
}  // namespace omega_slam::matching
