#include "omega_slam/graph/dense_elimination.h"

#include <Eigen/Cholesky>

namespace omega_slam::graph {

namespace {

using Eigen::Index;

/// Some rows of a panel's first columns times three rows of them, transposed.
template <int kRows>
class Tile {
 public:
  /// @param rows,others where these begin in the first column of `columns`
  Tile(const double* rows, const double* others, const ConstPanelMap& columns) {
    const Index stride = columns.rows();
    for (Index k = 0; k < columns.cols(); ++k, rows += stride, others += stride) {
      const Column column = Eigen::Map<const Column>(rows);
      first_ += column * others[0];
      second_ += column * others[1];
      third_ += column * others[2];
    }
  }

  void subtractFrom(double* target, Index stride) const {
    at(target) -= first_;
    at(target + stride) -= second_;
    at(target + 2 * stride) -= third_;
  }

  void negateInto(double* target, Index stride) const {
    at(target) = -first_;
    at(target + stride) = -second_;
    at(target + 2 * stride) = -third_;
  }

 private:
  using Column = Eigen::Array<double, kRows, 1>;

  static Eigen::Map<Column> at(double* target) { return Eigen::Map<Column>(target); }

  Column first_ = Column::Zero();
  Column second_ = Column::Zero();
  Column third_ = Column::Zero();
};

/// Takes from three columns what those before them say.
void subtractEarlier(PanelMap& panel, Index first) {
  const Index height = panel.rows();
  const ConstPanelMap earlier(panel.data(), height, first);
  const double* const rows = panel.data();
  double* const target = panel.data() + first * height;
  Index row = first;
  for (; row + 6 <= height; row += 6) {
    Tile<6>(rows + row, rows + first, earlier).subtractFrom(target + row, height);
  }
  if (row < height) {
    Tile<3>(rows + row, rows + first, earlier).subtractFrom(target + row, height);
  }
}

/// Eliminates three columns among themselves.
bool eliminateThree(PanelMap& panel, Index first) {
  const Eigen::LLT<Eigen::Matrix3d> own(panel.block<3, 3>(first, first));
  if (own.info() != Eigen::Success) {
    return false;
  }
  const Eigen::Matrix3d lower = own.matrixL();
  panel.block<3, 3>(first, first) = lower;
  const Index below = panel.rows() - first - 3;
  auto a = panel.col(first).tail(below);
  auto b = panel.col(first + 1).tail(below);
  auto c = panel.col(first + 2).tail(below);
  a *= 1.0 / lower(0, 0);
  b = (b - lower(1, 0) * a) * (1.0 / lower(1, 1));
  c = (c - lower(2, 0) * a - lower(2, 1) * b) * (1.0 / lower(2, 2));
  return true;
}

}  // namespace

bool eliminate(PanelMap panel) {
  for (Index first = 0; first < panel.cols(); first += 3) {
    subtractEarlier(panel, first);
    if (!eliminateThree(panel, first)) {
      return false;
    }
  }
  return true;
}

Eigen::MatrixXd leftBy(ConstPanelMap panel) {
  const Index height = panel.rows() - panel.cols();
  const double* const below = panel.data() + panel.cols();
  Eigen::MatrixXd update(height, height);
  for (Index column = 0; column < height; column += 3) {
    double* const target = update.data() + column * height;
    Index row = column;
    for (; row + 6 <= height; row += 6) {
      Tile<6>(below + row, below + column, panel).negateInto(target + row, height);
    }
    if (row < height) {
      Tile<3>(below + row, below + column, panel).negateInto(target + row, height);
    }
  }
  return update;
}

void substituteForward(ConstPanelMap panel, Eigen::VectorXd& x) {
  for (Index first = 0; first < panel.cols(); first += 3) {
    const auto own = panel.block<3, 3>(first, first);
    Eigen::Vector3d a = x.segment<3>(first);
    own.triangularView<Eigen::Lower>().solveInPlace(a);
    x.segment<3>(first) = a;
    const Index below = panel.rows() - first - 3;
    x.tail(below) -= a[0] * panel.col(first).tail(below) + a[1] * panel.col(first + 1).tail(below) +
                     a[2] * panel.col(first + 2).tail(below);
  }
}

void substituteBackward(ConstPanelMap panel, Eigen::VectorXd& x) {
  for (Index first = panel.cols() - 3; first >= 0; first -= 3) {
    const auto own = panel.block<3, 3>(first, first);
    const Index below = panel.rows() - first - 3;
    Eigen::Vector3d a = x.segment<3>(first);
    for (Index axis = 0; axis < 3; ++axis) {
      a[axis] -= panel.col(first + axis).tail(below).dot(x.tail(below));
    }
    own.transpose().triangularView<Eigen::Upper>().solveInPlace(a);
    x.segment<3>(first) = a;
  }
}

}  // namespace omega_slam::graph
