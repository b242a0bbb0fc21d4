#include "omega_slam/graph/dense_elimination.h"

#include <cmath>
#include <optional>

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

/// Calls `use(tile, row)` for the tiles from three rows on downwards, times these three.
/// @param rows where the first row begins in the first column of `columns`
/// @param height of rows that there are
template <class Use>
void visitTiles(const double* rows, Index three, Index height, const ConstPanelMap& columns,
                const Use& use) {
  Index row = three;
  for (; row + 6 <= height; row += 6) {
    use(Tile<6>(rows + row, rows + three, columns), row);
  }
  if (row < height) {
    use(Tile<3>(rows + row, rows + three, columns), row);
  }
}

/// Takes from three columns what those before them say.
void subtractEarlier(PanelMap& panel, Index first) {
  const Index height = panel.rows();
  double* const target = panel.data() + first * height;
  visitTiles(panel.data(), first, height, {panel.data(), height, first},
             [&](const auto& tile, Index row) { tile.subtractFrom(target + row, height); });
}

/// L of a block on the diagonal. Divisions are slow, so the panel has the reciprocals of L's own
/// diagonal, too: above it, where nothing else stands.
struct DiagonalBlock {
  double l10, l20, l21;
  double r0, r1, r2;  ///< 1 / l00, 1 / l11, 1 / l22

  [[nodiscard]] static DiagonalBlock of(const ConstPanelMap& panel, Index first) {
    const auto block = panel.block<3, 3>(first, first);
    return {block(1, 0), block(2, 0), block(2, 1), block(0, 1), block(0, 2), block(1, 2)};
  }

  /// L^-1 v
  [[nodiscard]] Eigen::Vector3d forward(const Eigen::Vector3d& v) const {
    const double a = v[0] * r0;
    const double b = (v[1] - l10 * a) * r1;
    return {a, b, (v[2] - l20 * a - l21 * b) * r2};
  }

  /// L^-T v
  [[nodiscard]] Eigen::Vector3d backward(const Eigen::Vector3d& v) const {
    const double c = v[2] * r2;
    const double b = (v[1] - l21 * c) * r1;
    return {(v[0] - l10 * b - l20 * c) * r0, b, c};
  }
};

/// @return none where the block is not positive definite
std::optional<DiagonalBlock> factorizeBlock(PanelMap& panel, Index first) {
  const Eigen::Matrix3d omega = panel.block<3, 3>(first, first);
  const double l00 = std::sqrt(omega(0, 0));
  const double r0 = 1.0 / l00;
  const double l10 = omega(1, 0) * r0;
  const double l20 = omega(2, 0) * r0;
  const double l11 = std::sqrt(omega(1, 1) - l10 * l10);
  const double r1 = 1.0 / l11;
  const double l21 = (omega(2, 1) - l20 * l10) * r1;
  const double l22 = std::sqrt(omega(2, 2) - l20 * l20 - l21 * l21);
  const double r2 = 1.0 / l22;
  if (!(l00 > 0.0 && l11 > 0.0 && l22 > 0.0)) {  // so it is for NaN
    return std::nullopt;
  }
  panel.block<3, 3>(first, first) << l00, r0, r1,  //
      l10, l11, r2,                                //
      l20, l21, l22;
  return DiagonalBlock{l10, l20, l21, r0, r1, r2};
}

/// Eliminates three columns among themselves.
bool eliminateThree(PanelMap& panel, Index first) {
  const auto own = factorizeBlock(panel, first);
  if (!own) {
    return false;
  }
  const Index below = panel.rows() - first - 3;
  auto a = panel.col(first).tail(below);
  auto b = panel.col(first + 1).tail(below);
  auto c = panel.col(first + 2).tail(below);
  a *= own->r0;
  b = (b - own->l10 * a) * own->r1;
  c = (c - own->l20 * a - own->l21 * b) * own->r2;
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
    visitTiles(below, column, height, panel,
               [&](const auto& tile, Index row) { tile.negateInto(target + row, height); });
  }
  return update;
}

void substituteForward(ConstPanelMap panel, Eigen::VectorXd& x) {
  for (Index first = 0; first < panel.cols(); first += 3) {
    const Eigen::Vector3d a = DiagonalBlock::of(panel, first).forward(x.segment<3>(first));
    x.segment<3>(first) = a;
    const Index below = panel.rows() - first - 3;
    x.tail(below) -= a[0] * panel.col(first).tail(below) + a[1] * panel.col(first + 1).tail(below) +
                     a[2] * panel.col(first + 2).tail(below);
  }
}

void substituteBackward(ConstPanelMap panel, Eigen::VectorXd& x) {
  for (Index first = panel.cols() - 3; first >= 0; first -= 3) {
    const Index below = panel.rows() - first - 3;
    const Eigen::Vector3d a =
        x.segment<3>(first) -
        panel.block(first + 3, first, below, 3).transpose().lazyProduct(x.tail(below));
    x.segment<3>(first) = DiagonalBlock::of(panel, first).backward(a);
  }
}

}  // namespace omega_slam::graph
