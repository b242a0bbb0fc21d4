#include "slam/crispness.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/point_index.h"

namespace omega_slam::experiments {
namespace {

constexpr double kRadius = 0.3;          // [m]
constexpr std::size_t kFewest = 10;      // neighbours
constexpr std::size_t kEvery = 7;        // endpoint is judged; all of them make up the walls
constexpr double kLeastVariance = 1e-8;  // [m^2] points in one line have no area

matching::Points endpoints(const std::vector<matching::View>& views,
                           const std::vector<geometry::Pose2>& poses) {
  matching::Points points;
  for (std::size_t k = 0; k < views.size(); ++k) {
    for (const Eigen::Vector2d& point : views[k].points) {
      points.push_back(poses[k] * point);
    }
  }
  return points;
}

/// The points around one of them as a normal distribution.
struct Surroundings {
  Eigen::Vector2d mean{0.0, 0.0};
  Eigen::Matrix2d covariance{Eigen::Matrix2d::Zero()};
};

Surroundings surroundingsOf(const matching::Points& points,
                            const std::vector<matching::PointIndex::Neighbour>& neighbours) {
  Surroundings found;
  const auto count = static_cast<double>(neighbours.size());
  for (const auto& neighbour : neighbours) {
    found.mean += points[neighbour.index] / count;
  }
  for (const auto& neighbour : neighbours) {
    const Eigen::Vector2d offset = points[neighbour.index] - found.mean;
    found.covariance += offset * offset.transpose() / count;
  }
  return found;
}

}  // namespace

Crispness judgeCrispness(const std::vector<matching::View>& views,
                         const std::vector<geometry::Pose2>& poses) {
  const matching::Points points = endpoints(views, poses);
  const matching::PointIndex index(points);
  std::vector<matching::PointIndex::Neighbour> neighbours;
  Crispness sum;
  std::size_t count = 0;
  for (std::size_t k = 0; k < points.size(); k += kEvery) {
    index.within(points[k], kRadius, neighbours);
    if (neighbours.size() < kFewest) {
      continue;
    }
    const Surroundings around = surroundingsOf(points, neighbours);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(around.covariance);
    const Eigen::Vector2d across = axes.eigenvectors().col(0);
    const Eigen::Vector2d variances = axes.eigenvalues().cwiseMax(kLeastVariance);
    sum.wall_distance += std::abs(across.dot(points[k] - around.mean));
    sum.entropy += std::log(2.0 * geometry::kPi) + 1.0 + 0.5 * std::log(variances.prod());
    ++count;
  }
  const double share = count > 0 ? 1.0 / static_cast<double>(count) : 0.0;
  return {share * sum.wall_distance, share * sum.entropy};
}

}  // namespace omega_slam::experiments
