#include "omega_slam/io/trajectory_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/grid/atomic_file.h"
#include "support/temporary_folder.h"

namespace omega_slam::io {
namespace {

TEST(TrajectoryFile, WritesTum) {
  EXPECT_EQ(toTum({{976052857.3375301, {1.5, -2.0, 0.0}}, {1.0, {-1e-12, 0.1, 2.0}}}),
            "976052857.337530 1.500000000 -2.000000000 0 0 0 0.000000000 1.000000000\n"
            "1.000000 0.000000000 0.100000000 0 0 0 0.841470985 0.540302306\n");
  EXPECT_EQ(toTum({}), "");
}

TEST(TrajectoryFile, ReadsTumWithCommentsAndTilt) {
  const test::TemporaryFolder folder;
  const geometry::Trajectory trajectory =
      readTrajectory(folder.write("t.tum",
                                  "# stamp x y z qx qy qz qw\n\n2 1 2 9 0 0 1 0 # turned round\n"
                                  "1 3 4 0 0.0 0.0 -0.479425539 -0.877582562\r\n"));
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory[0].stamp, 2.0);  // as in the file, not sorted
  EXPECT_NEAR(std::abs(trajectory[0].pose.theta), 3.14159265, 1e-8);
  EXPECT_NEAR(trajectory[1].pose.theta, 1.0, 1e-8);
  EXPECT_EQ(trajectory[1].pose.y, 4.0);
}

TEST(TrajectoryFile, WritesAtomically) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "deep" / "t.tum";
  EXPECT_EQ(writeTrajectory(path, {{1.0, {1, 2, 0.5}}}), "");
  EXPECT_EQ(grid::readFile(path), toTum({{1.0, {1, 2, 0.5}}}));
  EXPECT_NE(writeTrajectory(path / "below", {}), "");
}

TEST(TrajectoryFile, ReadsOdometry) {
  const test::TemporaryFolder folder;
  const geometry::Trajectory odometry =
      readOdometry(folder.write("o", "# t x y theta\n1.5 2 3 -0.5\n"));
  ASSERT_EQ(odometry.size(), 1U);
  EXPECT_EQ(odometry[0].stamp, 1.5);
  EXPECT_EQ(odometry[0].pose.vector(), Eigen::Vector3d(2, 3, -0.5));
}

TEST(TrajectoryFile, ReadsRelations) {
  const test::TemporaryFolder folder;
  const auto relations = readRelations(folder.write("r", "10 20 1 2 3 0.1 0.2 0.3\n"));
  ASSERT_EQ(relations.size(), 1U);
  EXPECT_EQ(relations[0].from_stamp, 10.0);
  EXPECT_EQ(relations[0].to_stamp, 20.0);
  EXPECT_EQ(relations[0].T_from_to.x, 1.0);
  EXPECT_EQ(relations[0].T_from_to.y, 2.0);
  EXPECT_DOUBLE_EQ(relations[0].T_from_to.theta, 0.3);
}

}  // namespace
}  // namespace omega_slam::io
