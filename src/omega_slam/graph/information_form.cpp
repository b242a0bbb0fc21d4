#include "omega_slam/graph/information_form.h"

#include <algorithm>
#include <cstdint>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::graph {

using geometry::Pose2;

InformationForm::InformationForm(std::size_t poses, const std::vector<Constraint>& constraints,
                                 const std::vector<NodeId>& held)
    : held_(poses, false), xi_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * poses))) {
  for (const NodeId node : held) {
    held_[node] = true;
  }
  buildBlocks(poses, constraints);
  buildOmega();
  places_.reserve(constraints.size());
  for (const Constraint& constraint : constraints) {
    places_.push_back(placeOf(constraint));
  }
  clear();
}

void InformationForm::buildBlocks(std::size_t poses, const std::vector<Constraint>& constraints) {
  std::vector<std::vector<int>> rows(poses);  // of each column
  for (std::size_t node = 0; node < poses; ++node) {
    rows[node].push_back(static_cast<int>(node));
  }
  for (const Constraint& constraint : constraints) {
    if (!held_[constraint.from] && !held_[constraint.to]) {
      const auto [column, row] = std::minmax(constraint.from, constraint.to);
      rows[column].push_back(static_cast<int>(row));
    }
  }
  const auto n = static_cast<Eigen::Index>(poses);
  blocks_.resize(n, n);
  for (std::size_t column = 0; column < poses; ++column) {
    std::vector<int>& of_column = rows[column];
    std::sort(of_column.begin(), of_column.end());
    of_column.erase(std::unique(of_column.begin(), of_column.end()), of_column.end());
    blocks_.startVec(static_cast<Eigen::Index>(column));
    for (const int row : of_column) {
      blocks_.insertBack(row, static_cast<Eigen::Index>(column)) = 1.0;
    }
  }
  blocks_.finalize();
}

/// Three columns of three rows for each block. The upper part of the blocks on the diagonal stands
/// there too, which costs little and makes all blocks alike; whoever factorises does not read it.
void InformationForm::buildOmega() {
  omega_.resize(3 * blocks_.rows(), 3 * blocks_.cols());
  omega_.resizeNonZeros(9 * blocks_.nonZeros());
  int* const columns = omega_.outerIndexPtr();
  int* const rows = omega_.innerIndexPtr();
  int element = 0;
  for (Eigen::Index column = 0; column < omega_.cols(); ++column) {
    columns[column] = element;
    for (Eigen::SparseMatrix<double>::InnerIterator block(blocks_, column / 3); block; ++block) {
      for (int axis = 0; axis < 3; ++axis) {
        rows[element++] = 3 * static_cast<int>(block.row()) + axis;
      }
    }
  }
  columns[omega_.cols()] = element;
}

InformationForm::Block InformationForm::blockAt(NodeId row, NodeId column) const {
  const int* const begin = blocks_.innerIndexPtr() + blocks_.outerIndexPtr()[column];
  const int* const end = blocks_.innerIndexPtr() + blocks_.outerIndexPtr()[column + 1];
  const auto before = std::lower_bound(begin, end, static_cast<int>(row)) - begin;
  const int* const columns = omega_.outerIndexPtr() + 3 * column;
  return {columns[0] + 3 * before, columns[1] - columns[0]};
}

InformationForm::Place InformationForm::placeOf(const Constraint& constraint) const {
  const auto [earlier, later] = std::minmax(constraint.from, constraint.to);
  Place place;
  place.from = 3 * static_cast<Eigen::Index>(constraint.from);
  place.to = 3 * static_cast<Eigen::Index>(constraint.to);
  place.to_is_later = constraint.to == later;
  if (!held_[constraint.from]) {
    place.from_from = blockAt(constraint.from, constraint.from);
  }
  if (!held_[constraint.to]) {
    place.to_to = blockAt(constraint.to, constraint.to);
  }
  if (!held_[constraint.from] && !held_[constraint.to]) {
    place.across = blockAt(later, earlier);
  }
  return place;
}

void InformationForm::addTo(const Block& block, const Eigen::Matrix3d& values) {
  using Columns = Eigen::Map<Eigen::Matrix3d, Eigen::Unaligned, Eigen::OuterStride<>>;
  if (block.isThere()) {
    Columns(omega_.valuePtr() + block.first, Eigen::OuterStride<>(block.stride)) += values;
  }
}

void InformationForm::clear() {
  std::fill_n(omega_.valuePtr(), omega_.nonZeros(), 0.0);
  xi_.setZero();
  for (std::size_t node = 0; node < held_.size(); ++node) {
    if (held_[node]) {
      const auto id = static_cast<NodeId>(node);
      addTo(blockAt(id, id), Eigen::Matrix3d::Identity());
    }
  }
}

void InformationForm::add(std::size_t k, const LinearizedConstraint& at,
                          const Eigen::Matrix3d& information) {
  const Place& place = places_[k];
  const Eigen::Matrix3d by_from = at.J_from.transpose() * information;
  const Eigen::Matrix3d by_to = at.J_to.transpose() * information;
  addTo(place.from_from, by_from * at.J_from);
  addTo(place.to_to, by_to * at.J_to);
  if (place.to_is_later) {
    addTo(place.across, by_to * at.J_from);
  } else {
    addTo(place.across, by_from * at.J_to);
  }
  if (place.from_from.isThere()) {
    xi_.segment<3>(place.from) -= by_from * at.error;
  }
  if (place.to_to.isThere()) {
    xi_.segment<3>(place.to) -= by_to * at.error;
  }
}

void InformationForm::damp(double share) {
  for (std::size_t node = 0; node < held_.size(); ++node) {
    const auto id = static_cast<NodeId>(node);
    const Block block = blockAt(id, id);
    for (int axis = 0; axis < 3; ++axis) {
      omega_.valuePtr()[block.diagonal(axis)] *= 1.0 + share;
    }
  }
}

void InformationForm::addDiagonal(NodeId node, int axis, double value) {
  omega_.valuePtr()[blockAt(node, node).diagonal(axis)] += value;
}

LinearizedConstraint paperConstraint(const Constraint& constraint, const Pose2& T_map_from,
                                     const Pose2& T_map_to) {
  const Pose2& measured = constraint.T_from_to;
  LinearizedConstraint result;
  result.J_from = -Eigen::Matrix3d::Identity();
  result.J_to = Eigen::Matrix3d::Identity();
  result.error.head<2>() = T_map_to.translation() - T_map_from.translation() -
                           T_map_from.rotation() * measured.translation();
  result.error[2] = geometry::angleDifference(
      geometry::angleDifference(T_map_to.theta, T_map_from.theta), measured.theta);
  return result;
}

}  // namespace omega_slam::graph
