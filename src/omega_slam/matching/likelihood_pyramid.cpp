#include "omega_slam/matching/likelihood_pyramid.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace omega_slam::matching {

namespace {

using Likelihoods = std::vector<std::uint8_t>;  // by squared distance [cells^2]

/// For all distances within the square around a surface that is drawn.
Likelihoods likelihoodsWithin(int reach) {
  const int limit = reach * reach;
  Likelihoods values;
  for (int squared = 0; squared <= 2 * limit; ++squared) {
    const double share = std::max(0.0, 1.0 - static_cast<double>(squared) / limit);
    values.push_back(static_cast<std::uint8_t>(LikelihoodPyramid::kFull * share + 0.5));
  }
  return values;
}

/// Draws surfaces on one level.
class LevelPainter {
 public:
  LevelPainter(int reach, int level)
      : likelihoods_(likelihoodsWithin(reach)),
        reach_(reach),
        shift_(LikelihoodPyramid::blockShift(level)),
        slack_(LikelihoodPyramid::slack(level)) {}

  [[nodiscard]] TiledGrid<std::uint8_t> paint(const std::vector<grid::Cell>& surfaces) {
    Eigen::AlignedBox2i box;
    for (const grid::Cell& cell : surfaces) {
      box.extend(cell);
    }
    if (box.isEmpty()) {
      return {};
    }
    TiledGrid<std::uint8_t> values({first(box.min().x()), first(box.min().y())},
                                   {last(box.max().x()), last(box.max().y())});
    for (const grid::Cell& cell : surfaces) {
      paint(cell, values);
    }
    return values;
  }

 private:
  /// Blocks in reach of a surface along one axis.
  [[nodiscard]] int first(int cell) const { return (cell - reach_ - slack_) >> shift_; }
  [[nodiscard]] int last(int cell) const { return (cell + reach_ + slack_) >> shift_; }

  /// From a surface to the nearest cell that a block speaks for, along one axis, squared.
  [[nodiscard]] int squaredGap(int cell, int block) const {
    const int side = 1 << shift_;
    const int low = block * side - slack_;
    const int high = (block + 1) * side - 1 + slack_;
    const int gap = std::max({0, low - cell, cell - high});
    return gap * gap;
  }

  void paint(const grid::Cell& cell, TiledGrid<std::uint8_t>& values) {
    const int first_x = first(cell.x());
    const int last_x = last(cell.x());
    gaps_.clear();
    for (int x = first_x; x <= last_x; ++x) {
      gaps_.push_back(squaredGap(cell.x(), x));
    }
    for (int y = first(cell.y()); y <= last(cell.y()); ++y) {
      const std::uint8_t* row = likelihoods_.data() + squaredGap(cell.y(), y);
      values.visitRow(first_x, last_x, y, [&](int x, std::uint8_t* cells, int count) {
        const int* gaps = gaps_.data() + (x - first_x);
        for (int i = 0; i < count; ++i) {
          cells[i] = std::max(cells[i], row[gaps[i]]);
        }
      });
    }
  }

  Likelihoods likelihoods_;
  int reach_;
  int shift_;
  int slack_;
  std::vector<int> gaps_;  // kept, so as not to allocate for each surface
};

}  // namespace

LikelihoodPyramid::LikelihoodPyramid(const std::vector<grid::Cell>& surfaces, int reach,
                                     int levels) {
  for (int level = 0; level < levels; ++level) {
    levels_.push_back(LevelPainter(reach, level).paint(surfaces));
  }
}

}  // namespace omega_slam::matching
