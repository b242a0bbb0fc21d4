#include "omega_slam/matching/correlation_volume.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "omega_slam/geometry/covariance.h"
#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

Eigen::Matrix3d diagonal(double x, double y, double theta) {
  return Eigen::Vector3d(x * x, y * y, theta * theta).asDiagonal();
}

TEST(CorrelationVolumeLaws, NeverMakesACovarianceNarrower) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points room = test::measurePoints(test::furnishedRoom(), {}, 180, 0.01, random);
    const CorrelativeSearch search(room, room, {}, {});
    for (int i = 0; i < 5; ++i) {
      const Eigen::Matrix3d root = 0.02 * Eigen::Matrix3d::Random();
      const Eigen::Matrix3d believed = root * root.transpose() + diagonal(0.01, 0.01, 0.003);
      const Eigen::Matrix3d wider =
          widenByVolume(search, test::randomPose(0.02, 0.01, random), believed, 0.02);
      EXPECT_TRUE(
          geometry::isPositiveSemidefinite(wider - believed + 1e-9 * Eigen::Matrix3d::Identity()));
    }
  }
}

TEST(CorrelationVolumeLaws, AFlatVolumeIsWideWhateverWasBelieved) {
  Points walls;
  for (int i = -400; i <= 400; ++i) {
    walls.emplace_back(0.03 * i, -1.0);
    walls.emplace_back(0.03 * i, 1.0);
  }
  Points scan;
  for (int i = -30; i <= 30; ++i) {
    scan.emplace_back(0.1 * i, -1.0);
    scan.emplace_back(0.1 * i, 1.0);
  }
  const CorrelativeSearch search(walls, scan, {}, {});
  const Eigen::Matrix3d wider = widenByVolume(search, {}, diagonal(0.01, 0.01, 0.003), 0.02);
  EXPECT_GT(std::sqrt(wider(0, 0)), 0.5) << "along the corridor";
  EXPECT_LT(std::sqrt(wider(1, 1)), 0.03) << "across";
  EXPECT_LT(std::sqrt(wider(2, 2)), 0.02);
}

TEST(CorrelationVolumeLaws, APeakIsAsWideAsItsScoresSay) {
  std::mt19937_64 random(1);
  const Points room = test::measurePoints(test::furnishedRoom(), {}, 720, 0.0, random);
  const CorrelativeSearch search(room, room, {}, {});
  // Believed to be known to a hair, so that all that remains is the volume's.
  const Eigen::Matrix3d sharp = widenByVolume(search, {}, diagonal(1e-4, 1e-4, 1e-4), 0.02);
  EXPECT_LT(std::sqrt(sharp(0, 0)), 0.02);
  EXPECT_GT(std::sqrt(sharp(0, 0)), 0.002);
  const Eigen::Matrix3d vague = widenByVolume(search, {}, diagonal(1e-4, 1e-4, 1e-4), 0.06);
  EXPECT_GT(vague(0, 0), 2.0 * sharp(0, 0)) << "noise makes a score say less";
}

}  // namespace
}  // namespace omega_slam::matching
