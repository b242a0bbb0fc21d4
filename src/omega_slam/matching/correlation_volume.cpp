#include "omega_slam/matching/correlation_volume.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kIndependentPoints = 30.0;
constexpr std::array<double, 5> kOffsets{-3.0, -1.5, 0.0, 1.5, 3.0};  // along an axis
constexpr double kFlat = 2.0;    // second moment: of a flat volume 4.5, of a normal one 1
constexpr double kWidest = 0.5;  // [m], [rad] length of an axis that is not made longer

/// How much more likely a pose is for scoring 1 more. A likelihood of 1 - (d / reach)^2 stands for
/// a probability of exp(-d^2 / (2 deviation^2)).
double sharpnessOf(double reach, double deviation) {
  return 0.5 * kIndependentPoints * reach * reach / (deviation * deviation);
}

/// Second moments of the volume in units of the axes, which are the columns of a matrix.
Eigen::Matrix3d momentsOf(const CorrelativeSearch& search, const Pose2& pose,
                          const Eigen::Matrix3d& axes, double sharpness) {
  const double center = search.score(pose);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double total = 0.0;
  for (const double i : kOffsets) {
    for (const double j : kOffsets) {
      for (const double k : kOffsets) {
        const Eigen::Vector3d offset(i, j, k);
        const double score = search.score(Pose2::fromVector(pose.vector() + axes * offset));
        // None counts more than the peak itself, which a step of the grid may score below.
        const double weight = std::exp(sharpness * std::min(score - center, 0.0));
        moments += weight * offset * offset.transpose();
        total += weight;
      }
    }
  }
  return moments / total;
}

}  // namespace

Eigen::Matrix3d widenByVolume(const CorrelativeSearch& search, const Pose2& pose,
                              const Eigen::Matrix3d& covariance, double deviation) {
  const double sharpness = sharpnessOf(search.reach(), deviation);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> believed(covariance);
  const Eigen::Vector3d deviations = believed.eigenvalues().cwiseSqrt();
  Eigen::Vector3d stretch = Eigen::Vector3d::Ones();
  Eigen::Matrix3d moments;
  for (bool is_wide_enough = false; !is_wide_enough;) {
    const Eigen::Vector3d lengths = deviations.cwiseProduct(stretch);
    moments = momentsOf(search, pose, believed.eigenvectors() * lengths.asDiagonal(), sharpness);
    is_wide_enough = true;
    for (int i = 0; i < 3; ++i) {
      if (moments(i, i) > kFlat && lengths[i] < kWidest) {
        stretch[i] *= 2.0;
        is_wide_enough = false;
      }
    }
  }
  // In units of the believed deviations; where they are less than one, belief wins.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> volume(stretch.asDiagonal() * moments *
                                                              stretch.asDiagonal());
  const Eigen::Matrix3d axes =
      believed.eigenvectors() * deviations.asDiagonal() * volume.eigenvectors();
  const Eigen::Matrix3d wider =
      axes * volume.eigenvalues().cwiseMax(1.0).asDiagonal() * axes.transpose();
  return 0.5 * (wider + wider.transpose());
}

}  // namespace omega_slam::matching
