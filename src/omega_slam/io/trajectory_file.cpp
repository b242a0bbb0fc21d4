#include "omega_slam/io/trajectory_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/io/number_lines.h"

namespace omega_slam::io {
namespace {

/// Rounds to so many decimals' worth, and gives up the sign of a zero, which is noise.
double withoutNegativeZero(double value, double unit) {
  return std::abs(value) < 0.5 * unit ? 0.0 : value;
}

/// Yaw of a quaternion [rad] (rotation about z of the z-y-x Euler angles).
double yawOf(double qx, double qy, double qz, double qw) {
  return std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
}

}  // namespace

std::string toTum(const geometry::Trajectory& trajectory) {
  constexpr double kUnit = 1e-9;
  fmt::memory_buffer text;
  for (const geometry::StampedPose2& entry : trajectory) {
    const auto tidy = [](double value) { return withoutNegativeZero(value, kUnit); };
    // The heading lies in [-pi, pi), its half in [-pi/2, pi/2): qw is never negative.
    const double half = 0.5 * geometry::normalizeAngle(entry.pose.theta);
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.9f} {:.9f} 0 0 0 {:.9f} {:.9f}\n",
                   entry.stamp, tidy(entry.pose.x), tidy(entry.pose.y), tidy(std::sin(half)),
                   tidy(std::cos(half)));
  }
  return fmt::to_string(text);
}

std::string writeTrajectory(const std::filesystem::path& path,
                            const geometry::Trajectory& trajectory) {
  return grid::writeFileAtomically(path, toTum(trajectory));
}

geometry::Trajectory readTrajectory(const std::filesystem::path& path) {
  geometry::Trajectory trajectory;
  for (const NumberLine& line : readNumberLines(path, "stamp x y z qx qy qz qw")) {
    const std::vector<double>& v = line.values;
    const double norm = v[4] * v[4] + v[5] * v[5] + v[6] * v[6] + v[7] * v[7];
    constexpr double kTolerance = 0.01;  // some tools write few decimals
    if (std::abs(norm - 1.0) > kTolerance) {
      throw std::runtime_error(
          fmt::format("{}:{}: the quaternion is not of unit length.", path.string(), line.line));
    }
    trajectory.push_back(
        {v[0], {v[1], v[2], geometry::normalizeAngle(yawOf(v[4], v[5], v[6], v[7]))}});
  }
  return trajectory;
}

geometry::Trajectory readOdometry(const std::filesystem::path& path) {
  geometry::Trajectory odometry;
  for (const NumberLine& line : readNumberLines(path, "stamp x y theta")) {
    const std::vector<double>& v = line.values;
    odometry.push_back({v[0], {v[1], v[2], geometry::normalizeAngle(v[3])}});
  }
  return odometry;
}

std::vector<graph::Relation> readRelations(const std::filesystem::path& path) {
  std::vector<graph::Relation> relations;
  for (const NumberLine& line : readNumberLines(path, "stamp1 stamp2 x y z roll pitch yaw")) {
    const std::vector<double>& v = line.values;
    relations.push_back({v[0], v[1], {v[2], v[3], geometry::normalizeAngle(v[7])}});
  }
  return relations;
}

}  // namespace omega_slam::io
