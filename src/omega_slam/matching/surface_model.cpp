#include "omega_slam/matching/surface_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace omega_slam::matching {

namespace {

constexpr double kSurfaceRadius = 0.3;  // [m] neighbours that make up the surface around a point
constexpr double kLineFlatness = 0.25;  // minor over major axis; above, it is no line

}  // namespace

Surface fitSurface(const Points& points, const std::vector<PointIndex::Neighbour>& members) {
  if (members.size() < 3) {
    return {};
  }
  const auto count = static_cast<double>(members.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& member : members) {
    mean += points[member.index] / count;
  }
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& member : members) {
    const Eigen::Vector2d d = points[member.index] - mean;
    scatter += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(scatter);
  const double across = std::max(axes.eigenvalues()[0], 0.0);
  const double along = axes.eigenvalues()[1];
  if (across >= kLineFlatness * kLineFlatness * along) {
    return {};
  }
  return {axes.eigenvectors().col(0), across / (count - 2.0) / along};
}

SurfaceModel::SurfaceModel(const Points& reference)
    : reference_(reference), index_(reference), surfaces_(reference.size()) {}

std::optional<SurfaceModel::Partner> SurfaceModel::partnerOf(const Eigen::Vector2d& p_reference,
                                                             double reach) {
  index_.nearest(p_reference, 1, neighbours_);
  if (neighbours_.empty() || neighbours_.front().squared_distance > reach * reach) {
    return std::nullopt;
  }
  const std::size_t nearest = neighbours_.front().index;
  if (!surfaces_[nearest]) {
    index_.within(reference_[nearest], kSurfaceRadius, neighbours_);
    surfaces_[nearest] = fitSurface(reference_, neighbours_);
  }
  return Partner{reference_[nearest], *surfaces_[nearest]};
}

}  // namespace omega_slam::matching
