#include "omega_slam/graph/information_form.h"

#include "omega_slam/geometry/angle.h"

namespace omega_slam::graph {

using geometry::Pose2;

InformationForm::InformationForm(std::size_t poses)
    : xi_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * poses))) {}

void InformationForm::add(NodeId i, NodeId j, const Eigen::Matrix3d& J_i,
                          const Eigen::Matrix3d& J_j, const Eigen::Matrix3d& information,
                          const Eigen::Vector3d& z) {
  const Eigen::Matrix3d weighted_i = J_i.transpose() * information;
  const Eigen::Matrix3d weighted_j = J_j.transpose() * information;
  addBlock(i, i, weighted_i * J_i);
  addBlock(j, j, weighted_j * J_j);
  if (i > j) {
    addBlock(i, j, weighted_i * J_j);
  } else {
    addBlock(j, i, weighted_j * J_i);
  }
  xi_.segment<3>(3 * static_cast<Eigen::Index>(i)) += weighted_i * z;
  xi_.segment<3>(3 * static_cast<Eigen::Index>(j)) += weighted_j * z;
}

void InformationForm::anchor(NodeId i, const Eigen::Vector3d& value, double weight) {
  addBlock(i, i, weight * Eigen::Matrix3d::Identity());
  xi_.segment<3>(3 * static_cast<Eigen::Index>(i)) += weight * value;
}

void InformationForm::addBlock(NodeId row, NodeId column, const Eigen::Matrix3d& block) {
  for (int r = 0; r < 3; ++r) {
    // Only the lower triangle; the upper mirrors it.
    const int last = row == column ? r : 2;
    for (int c = 0; c <= last; ++c) {
      triplets_.emplace_back(3 * static_cast<int>(row) + r, 3 * static_cast<int>(column) + c,
                             block(r, c));
    }
  }
}

Eigen::SparseMatrix<double> InformationForm::omega() const {
  Eigen::SparseMatrix<double> omega(xi_.size(), xi_.size());
  omega.setFromTriplets(triplets_.begin(), triplets_.end());
  return omega;
}

LinearizedConstraint linearize(const Constraint& constraint, const Pose2& T_map_from,
                               const Pose2& T_map_to) {
  const Pose2& measured = constraint.T_from_to;
  const Eigen::Matrix2d to_from = T_map_from.rotation().transpose();
  const Eigen::Matrix2d to_measurement = measured.rotation().transpose();
  const Eigen::Vector2d offset = to_from * (T_map_to.translation() - T_map_from.translation());

  LinearizedConstraint result;
  result.error.head<2>() = to_measurement * (offset - measured.translation());
  result.error[2] = geometry::normalizeAngle(
      geometry::angleDifference(T_map_to.theta, T_map_from.theta) - measured.theta);

  const Eigen::Matrix2d both = to_measurement * to_from;
  result.J_from.setZero();
  result.J_from.topLeftCorner<2, 2>() = -both;
  // Turning `from` by a positive angle turns what it sees the other way.
  result.J_from.topRightCorner<2, 1>() = to_measurement * Eigen::Vector2d(offset.y(), -offset.x());
  result.J_from(2, 2) = -1.0;
  result.J_to.setZero();
  result.J_to.topLeftCorner<2, 2>() = both;
  result.J_to(2, 2) = 1.0;
  return result;
}

InformationForm paperForm(const std::vector<Constraint>& constraints, std::size_t poses,
                          const Pose2& origin) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  InformationForm form(poses);
  for (const Constraint& constraint : constraints) {
    form.add(constraint.from, constraint.to, -one, one, one, constraint.T_from_to.vector());
  }
  form.anchor(0, origin.vector(), 1.0);
  return form;
}

}  // namespace omega_slam::graph
