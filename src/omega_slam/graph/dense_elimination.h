#pragma once

#include <Eigen/Core>

namespace omega_slam::graph {

// The dense part of a sparse factorisation, in tiles of six rows and three columns: as many sums as
// a processor has registers for. Heights and widths are multiples of three.

using PanelMap = Eigen::Map<Eigen::MatrixXd>;
using ConstPanelMap = Eigen::Map<const Eigen::MatrixXd>;

/// Eliminates the columns of a panel [A; B], A symmetric and given by its lower triangle: A becomes
/// L with L L^T = A, and B becomes B L^-T. Above L's diagonal stands what the other functions need.
/// @return whether A is positive definite
[[nodiscard]] bool eliminate(PanelMap panel);

/// What an eliminated panel leaves to add to the rows below it: -B B^T, its lower triangle.
[[nodiscard]] Eigen::MatrixXd leftBy(ConstPanelMap panel);

/// With an eliminated panel [L; B] and x = [a; c]: a becomes L^-1 a, c becomes c - B L^-1 a.
void substituteForward(ConstPanelMap panel, Eigen::VectorXd& x);

/// And a becomes L^-T (a - B^T c).
void substituteBackward(ConstPanelMap panel, Eigen::VectorXd& x);

}  // namespace omega_slam::graph
