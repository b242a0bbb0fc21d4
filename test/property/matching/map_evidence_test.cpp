#include "omega_slam/matching/map_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/poses.h"
#include "support/room.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr double kReach = 0.1;  // looked at in the grid of 5 cm

/// The same from the definition, cell by cell: the eight by eight around the corner next to the
/// place.
void addPoint(const ValueGrid& grid, const Eigen::Vector2d& p_map, const Eigen::Vector2d& arm,
              MatchEvidence& evidence) {
  const double side = grid.geometry.resolution;
  const Eigen::Vector2d corner = ((p_map - grid.geometry.origin) / side).array().round();
  double weight = 0.0;
  std::size_t count = 0;
  Eigen::Vector2d sum(0.0, 0.0);
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Vector2d nearest = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  for (int y = -4; y < 4; ++y) {
    for (int x = -4; x < 4; ++x) {
      const grid::Cell cell = corner.cast<int>() + grid::Cell(x, y);
      const double value =
          grid.geometry.contains(cell) ? grid.values[grid.geometry.index(cell)] : 0.0;
      if (value > 0.0) {
        const Eigen::Vector2d way = grid.geometry.center(cell) - p_map;
        ++count;
        weight += value;
        sum += value * way;
        squares += value * way * way.transpose();
        nearest = way.norm() < nearest.norm() ? way : nearest;
      }
    }
  }
  if (count == 0 || nearest.norm() > kReach) {
    return;
  }
  const Eigen::Vector2d mean = sum / weight;
  const Eigen::Matrix2d scatter =
      static_cast<double>(count) * (squares / weight - mean * mean.transpose());
  const Surface surface = fitSurface(scatter, count);
  evidence.add(surface, surface.isLine() ? -mean : -nearest, arm);
}

TEST(MapEvidenceLaws, CellsAreSummedUpAsOneByOne) {
  for (const auto seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Points scan = test::measurePoints(test::furnishedRoom(), {}, 180, 0.02, random);
    const LocalMap map({}, {{scan, {0.0, 0.0}}});
    for (const double far : {0.05, 4.0}) {  // the latter leads across the map's border
      const Pose2 pose = test::randomPose(far, 0.3, random);
      const MatchEvidence evidence = gatherEvidence(map, scan, pose, kReach);
      MatchEvidence one_by_one;
      for (const auto& p_scan : scan) {
        const Eigen::Vector2d arm = pose.rotation() * p_scan;
        addPoint(map.grids()[1], arm + pose.translation(), arm, one_by_one);
      }
      EXPECT_EQ(evidence.partners, one_by_one.partners);
      EXPECT_NEAR(evidence.squared_residuals, one_by_one.squared_residuals, 1e-9);
      EXPECT_LT((evidence.hessian - one_by_one.hessian).norm(),
                1e-6 * (1.0 + one_by_one.hessian.norm()));
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching
