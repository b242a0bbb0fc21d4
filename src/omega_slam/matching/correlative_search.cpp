#include "omega_slam/matching/correlative_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kLargestBlock = 0.8;   // [m] larger ones have bounds that say nothing
constexpr int kExactly = -(1 << 30);    // below all sums
constexpr int kNotAtAll = 1 << 30;      // above all sums
constexpr double kHandicap = 0.02;      // of the score, at the window's edge
constexpr double kLeastFarthest = 0.5;  // [m] a scan of nothing but a heap needs no finer turns

/// Rounds to the nearest. Casts round towards zero, which far away from it is down.
int nearestCell(double place) {
  constexpr int kOffset = 1 << 20;
  return static_cast<int>(place + (kOffset + 0.5)) - kOffset;
}

std::vector<grid::Cell> cellsOf(const Points& places, const Eigen::Vector2d& center, double side) {
  std::vector<grid::Cell> cells;
  cells.reserve(places.size());
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2d offset = (place - center) / side;
    cells.emplace_back(nearestCell(offset.x()), nearestCell(offset.y()));
  }
  // A third fall into one that is there already.
  const auto byRow = [](const grid::Cell& a, const grid::Cell& b) {
    return std::make_pair(a.y(), a.x()) < std::make_pair(b.y(), b.x());
  };
  std::sort(cells.begin(), cells.end(), byRow);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

int stepsWithin(double distance, double step) {
  return static_cast<int>(std::ceil(distance / step - 1e-9));
}

PoseLattice latticeFor(const Points& scan, const Pose2& guess,
                       const CorrelativeSearchConfig& config) {
  double farthest = kLeastFarthest;
  for (const Eigen::Vector2d& point : scan) {
    farthest = std::max(farthest, point.norm());
  }
  // A hair less than one cell, so that rounding does not make it more.
  const double turn = 0.999 * config.resolution / farthest;
  return {guess, config.resolution, turn, stepsWithin(config.window.translation, config.resolution),
          stepsWithin(config.window.rotation, turn)};
}

/// Enough for the window to be two or three of the largest blocks wide.
int levelsFor(const PoseLattice& lattice) {
  int level = 0;
  while ((1 << level) <= lattice.steps && (2 << level) * lattice.step <= kLargestBlock) {
    ++level;
  }
  return level + 1;
}

int sideOf(const PoseBlock& block) { return 1 << block.level; }

using Four = std::array<int, 4>;  // of four blocks

/// A block, the next in x, the next in y, and the next in both.
std::array<PoseBlock, 4> fourFrom(const PoseBlock& block) {
  const int side = sideOf(block);
  std::array<PoseBlock, 4> blocks{block, block, block, block};
  blocks[1].x = blocks[3].x = block.x + side;
  blocks[2].y = blocks[3].y = block.y + side;
  return blocks;
}

/// How far an interval of indices, `side` long, begins away from an index.
int gapTo(int index, int begin, int side) {
  return std::max({0, begin - index, index - (begin + side - 1)});
}

/// Whether all of an interval lies within `reach` of an index.
bool isWithin(int reach, int index, int begin, int side) {
  return index - begin <= reach && begin + side - 1 - index <= reach;
}

}  // namespace

Pose2 PoseLattice::poseAt(int x, int y, int a) const {
  return Pose2::fromVector({center.x + (x - steps) * step, center.y + (y - steps) * step,
                            center.theta + (a - turns) * turn});
}

/// The scan at the middle heading of a set of blocks, as blocks of the pyramid that its points fall
/// on if it stands at the window's corner.
class CorrelativeSearch::TurnedScan {
 public:
  TurnedScan(const CorrelativeSearch& search, int level, int a)
      : shift_(LikelihoodPyramid::blockShift(level)) {
    const PoseLattice& lattice = search.lattice_;
    const double middle = 0.5 * ((1 << level) - 1);
    const double heading = lattice.center.theta + (a + middle - lattice.turns) * lattice.turn;
    const Eigen::Vector2d axis =
        Eigen::Vector2d(std::cos(heading), std::sin(heading)) / lattice.step;
    const double offset = middle - lattice.steps;
    blocks_.reserve(search.scan_.size());
    for (const Eigen::Vector2d& p : search.scan_) {
      const double x = axis.x() * p.x() - axis.y() * p.y() + offset;
      const double y = axis.y() * p.x() + axis.x() * p.y() + offset;
      add({nearestCell(x) >> shift_, nearestCell(y) >> shift_});
    }
  }

  /// Sums of likelihoods for a block, the next in x, the next in y, and the next in both: as their
  /// places are found together, they cost little more than one. Any number not above `least` where
  /// a sum is not above that.
  [[nodiscard]] Four sums(const LikelihoodPyramid& pyramid, const PoseBlock& block,
                          const Four& least) const {
    const grid::Cell shift(block.x >> shift_, block.y >> shift_);
    const int step = sideOf(block) >> shift_;
    const int full = LikelihoodPyramid::kFull * points_;
    Four most{full, full, full, full};
    for (const Occupied& occupied : blocks_) {
      const auto likelihoods = pyramid.atFour(block.level, occupied.cell + shift, step);
      bool is_hopeless = true;
      for (std::size_t k = 0; k < most.size(); ++k) {
        most[k] -= (LikelihoodPyramid::kFull - likelihoods[k]) * occupied.points;
        is_hopeless = is_hopeless && most[k] <= least[k];
      }
      if (is_hopeless) {
        break;
      }
    }
    return most;
  }

 private:
  /// A block of the pyramid, and how many of the scan's points, one after the other, fall on it.
  struct Occupied {
    grid::Cell cell;
    int points{0};
  };

  void add(const grid::Cell& cell) {
    if (blocks_.empty() || blocks_.back().cell != cell) {
      blocks_.push_back({cell, 0});
    }
    ++blocks_.back().points;
    ++points_;
  }

  int shift_;
  int points_{0};
  std::vector<Occupied> blocks_;
};

struct CorrelativeSearch::Candidate {
  PoseBlock block;
  int bound{0};

  /// Whether `other` is to be looked at first. Total, so that the result does not depend on the
  /// queue.
  [[nodiscard]] bool operator<(const Candidate& other) const {
    const PoseBlock& a = block;
    const PoseBlock& b = other.block;
    return std::tie(bound, b.level, b.a, b.y, b.x) < std::tie(other.bound, a.level, a.a, a.y, a.x);
  }
};

/// The blocks that together hold all poses that may still be the best, best bound first.
class CorrelativeSearch::Frontier {
 public:
  explicit Frontier(const CorrelativeSearch& search)
      : search_(search), least_bound_(search.least_bound_) {
    const int level = search.pyramid_.levels() - 1;
    for (int below = 0; below <= level; ++below) {
      turned_scans_.emplace_back(
          static_cast<std::size_t>((2 * search.lattice_.turns >> below) + 1));
    }
    for (int a = 0; a <= 2 * search.lattice_.turns; a += 1 << level) {
      const int last = 2 * search.lattice_.steps;
      addPlaces({level, 0, 0, a}, last, last);
    }
  }

  /// Whether there is none left of which a pose could be of use.
  [[nodiscard]] bool empty() const { return queue_.empty() || queue_.top().bound <= least_bound_; }

  /// From now on, poses of no higher bound are of no use.
  void demand(int bound) { least_bound_ = std::max(least_bound_, bound); }

  [[nodiscard]] PoseBlock pop() {
    const PoseBlock block = queue_.top().block;
    queue_.pop();
    return block;
  }

  /// Adds the halves of a block in x, y and heading.
  void split(const PoseBlock& block) {
    const int half = sideOf(block) / 2;
    for (const int a : {block.a, block.a + half}) {
      if (a <= 2 * search_.lattice_.turns) {
        addPlaces({block.level - 1, block.x, block.y, a}, block.x + half, block.y + half);
      }
    }
  }

 private:
  /// Adds the blocks from `first` on, up to those that begin at the last x and y.
  void addPlaces(const PoseBlock& first, int last_x, int last_y) {
    const int last = 2 * search_.lattice_.steps;
    last_x = std::min(last_x, last);
    last_y = std::min(last_y, last);
    PoseBlock block = first;
    for (block.y = first.y; block.y <= last_y; block.y += 2 * sideOf(block)) {
      for (block.x = first.x; block.x <= last_x; block.x += 2 * sideOf(block)) {
        addFour(fourFrom(block), last_x, last_y);
      }
    }
  }

  /// Adds those of four blocks that begin no later than the last x and y.
  void addFour(const std::array<PoseBlock, 4>& blocks, int last_x, int last_y) {
    Four less{};
    Four least{};
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const bool is_wanted = blocks[k].x <= last_x && blocks[k].y <= last_y;
      less[k] = is_wanted ? search_.less(blocks[k]) : 0;
      least[k] = is_wanted ? least_bound_ + less[k] : kNotAtAll;
    }
    const PoseBlock& first = blocks.front();
    const Four sums = turnedScan(first.level, first.a).sums(search_.pyramid_, first, least);
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      if (sums[k] > least[k]) {
        queue_.push({blocks[k], sums[k] - less[k]});
      }
    }
  }

  /// Made when it is first asked for: blocks of the same headings share it.
  const TurnedScan& turnedScan(int level, int a) {
    std::optional<TurnedScan>& scan =
        turned_scans_[static_cast<std::size_t>(level)][static_cast<std::size_t>(a >> level)];
    if (!scan) {
      scan.emplace(search_, level, a);
    }
    return *scan;
  }

  const CorrelativeSearch& search_;
  int least_bound_;
  std::priority_queue<Candidate> queue_;
  std::vector<std::vector<std::optional<TurnedScan>>> turned_scans_;  // by level, and heading
};

CorrelativeSearch::CorrelativeSearch(const Points& surfaces, const Points& scan, const Pose2& guess,
                                     const CorrelativeSearchConfig& config)
    : scan_(scan),
      reach_(config.reach),
      least_bound_(boundOf(config.least_score)),
      least_rival_(config.least_rival),
      lattice_(latticeFor(scan, guess, config)),
      pyramid_(cellsOf(surfaces, guess.translation(), config.resolution),
               stepsWithin(config.reach, config.resolution), levelsFor(lattice_)) {}

std::vector<CorrelativePeak> CorrelativeSearch::peaks(std::size_t count,
                                                      const SearchWindow& apart) const {
  const int steps = stepsWithin(apart.translation, lattice_.step);
  const int turns = stepsWithin(apart.rotation, lattice_.turn);
  std::vector<PoseBlock> found;
  const auto poseOf = [this](const PoseBlock& block) {
    return lattice_.poseAt(block.x, block.y, block.a);
  };
  const auto is_known = [&](const PoseBlock& block) {
    const int side = sideOf(block);
    return std::any_of(found.begin(), found.end(), [&](const PoseBlock& peak) {
      return isWithin(steps, peak.x, block.x, side) && isWithin(steps, peak.y, block.y, side) &&
             isWithin(turns, peak.a, block.a, side);
    });
  };
  for (Frontier frontier(*this); found.size() < count && !frontier.empty();) {
    const PoseBlock block = frontier.pop();
    if (is_known(block)) {
      continue;
    }
    if (block.level == 0) {
      found.push_back(block);
      frontier.demand(boundOf(least_rival_ * score(poseOf(found.front()))));
    } else {
      frontier.split(block);
    }
  }
  std::vector<CorrelativePeak> peaks;
  for (const PoseBlock& block : found) {
    peaks.push_back({poseOf(block), score(poseOf(block))});
  }
  return peaks;
}

double CorrelativeSearch::score(const Pose2& T_reference_scan) const {
  const Eigen::Matrix2d turn = T_reference_scan.rotation() / lattice_.step;
  const Eigen::Vector2d origin =
      (T_reference_scan.translation() - lattice_.center.translation()) / lattice_.step;
  int sum = 0;
  for (const Eigen::Vector2d& p_scan : scan_) {
    const Eigen::Vector2d place = turn * p_scan + origin;
    sum += pyramid_.at(0, nearestCell(place.x()), nearestCell(place.y()));
  }
  return scan_.empty() ? 0.0 : sum / (LikelihoodPyramid::kFull * static_cast<double>(scan_.size()));
}

int CorrelativeSearch::bound(const PoseBlock& block) const {
  const TurnedScan scan(*this, block.level, block.a);
  return scan.sums(pyramid_, block, {kExactly, kNotAtAll, kNotAtAll, kNotAtAll})[0] - less(block);
}

/// A mean likelihood in the units of sums.
int CorrelativeSearch::boundOf(double score) const {
  return static_cast<int>(score * LikelihoodPyramid::kFull * static_cast<double>(scan_.size()));
}

/// The handicap in the units of sums.
int CorrelativeSearch::less(const PoseBlock& block) const {
  const double full = LikelihoodPyramid::kFull * static_cast<double>(scan_.size());
  return static_cast<int>(handicap(block) * full);
}

double CorrelativeSearch::handicap(const PoseBlock& block) const {
  const int side = sideOf(block);
  const Eigen::Vector2d away(gapTo(lattice_.steps, block.x, side),
                             gapTo(lattice_.steps, block.y, side));
  const double turned = gapTo(lattice_.turns, block.a, side);
  return kHandicap *
         (away.norm() / std::max(lattice_.steps, 1) + turned / std::max(lattice_.turns, 1));
}

}  // namespace omega_slam::matching
