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
        slack_(LikelihoodPyramid::slack(level)),
        stamps_(std::size_t{1} << (2 * shift_)) {}

  [[nodiscard]] TiledGrid<std::uint8_t> paint(const std::vector<grid::Cell>& surfaces) {
    Eigen::AlignedBox2i box;
    for (const grid::Cell& cell : surfaces) {
      box.extend(cell);
    }
    if (box.isEmpty()) {
      return {};
    }
    TiledGrid<std::uint8_t> values(first(box.min()), last(box.max()));
    for (const grid::Cell& cell : surfaces) {
      press(cell, values);
    }
    return values;
  }

 private:
  /// What a surface gives the blocks around it.
  using Stamp = std::vector<std::uint8_t>;

  /// Blocks in reach of a surface.
  [[nodiscard]] grid::Cell first(const grid::Cell& cell) const {
    return {(cell.x() - reach_ - slack_) >> shift_, (cell.y() - reach_ - slack_) >> shift_};
  }
  [[nodiscard]] grid::Cell last(const grid::Cell& cell) const {
    return {(cell.x() + reach_ + slack_) >> shift_, (cell.y() + reach_ + slack_) >> shift_};
  }

  /// From a surface to the nearest cell that a block speaks for, along one axis, squared.
  [[nodiscard]] int squaredGap(int cell, int block) const {
    const int side = 1 << shift_;
    const int low = block * side - slack_;
    const int high = (block + 1) * side - 1 + slack_;
    const int gap = std::max({0, low - cell, cell - high});
    return gap * gap;
  }

  void press(const grid::Cell& cell, TiledGrid<std::uint8_t>& values) {
    const std::uint8_t* stamp = stampFor(cell).data();
    const grid::Cell low = first(cell);
    const grid::Cell high = last(cell);
    for (int y = low.y(); y <= high.y(); ++y) {
      values.visitRow(low.x(), high.x(), y, [&](int, std::uint8_t* cells, int count) {
        for (int i = 0; i < count; ++i) {
          cells[i] = std::max(cells[i], stamp[i]);
        }
        stamp += count;
      });
    }
  }

  /// The same for all surfaces that lie alike in their block.
  const Stamp& stampFor(const grid::Cell& cell) {
    const int mask = (1 << shift_) - 1;
    Stamp& stamp =
        stamps_[static_cast<std::size_t>(((cell.y() & mask) << shift_) + (cell.x() & mask))];
    if (stamp.empty()) {
      const grid::Cell low = first(cell);
      const grid::Cell high = last(cell);
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          const int squared = squaredGap(cell.x(), x) + squaredGap(cell.y(), y);
          stamp.push_back(likelihoods_[static_cast<std::size_t>(squared)]);
        }
      }
    }
    return stamp;
  }

  Likelihoods likelihoods_;
  int reach_;
  int shift_;
  int slack_;
  std::vector<Stamp> stamps_;  // made when they are first asked for
};

}  // namespace

LikelihoodPyramid::LikelihoodPyramid(const std::vector<grid::Cell>& surfaces, int reach,
                                     int levels) {
  for (int level = 0; level < levels; ++level) {
    levels_.push_back(LevelPainter(reach, level).paint(surfaces));
  }
}

}  // namespace omega_slam::matching
