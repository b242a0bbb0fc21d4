#include <gtest/gtest.h>

#include <random>
#include <set>

#include "omega_slam/exploration/fast_detector.h"
#include "omega_slam/exploration/wavefront_detector.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "support/drawn_world.h"
#include "support/seeds.h"
#include "support/toy_robot.h"

namespace omega_slam::exploration {
namespace {

using geometry::Pose2;
using Cells = std::vector<std::pair<int, int>>;

/// Frontiers as sets of cells: what does not depend on who has found them.
std::set<Cells> shapesOf(const std::vector<Frontier>& frontiers) {
  std::set<Cells> shapes;
  for (const Frontier& frontier : frontiers) {
    Cells cells;
    for (const Cell& cell : frontier.cells) {
      cells.emplace_back(cell.x(), cell.y());
    }
    shapes.insert(cells);
  }
  return shapes;
}

std::vector<Frontier> listOf(const FrontierStore& store) {
  std::vector<Frontier> list;
  for (const auto& [id, frontier] : store.all()) {
    list.push_back(frontier);
  }
  return list;
}

std::shared_ptr<const simulation::World> randomWorld(std::mt19937_64& random) {
  std::vector<std::string> rows(60, "#" + std::string(98, ' ') + "#");
  rows.front() = rows.back() = std::string(100, '#');
  std::uniform_int_distribution<std::size_t> row(1, 58);
  std::uniform_int_distribution<std::size_t> col(1, 98);
  std::uniform_int_distribution<std::size_t> extent(1, 14);
  for (int i = 0; i < 25; ++i) {
    const std::size_t top = row(random);
    const std::size_t left = col(random);
    const std::size_t height = i % 2 == 0 ? 1 : extent(random);
    const std::size_t width = i % 2 == 0 ? extent(random) : 1;
    for (std::size_t r = top; r < std::min<std::size_t>(top + height, 59); ++r) {
      for (std::size_t c = left; c < std::min<std::size_t>(left + width, 99); ++c) {
        rows[r][c] = '#';
      }
    }
  }
  return test::drawnWorld(rows, 0.1);
}

/// Walks at random through the open and measures with noise, so that verdicts of cells change.
class RandomRun {
 public:
  explicit RandomRun(std::uint64_t seed) : random_(seed), world_(randomWorld(random_)) {
    std::uniform_real_distribution<double> x(0.5, 9.5);
    std::uniform_real_distribution<double> y(0.5, 5.5);
    do {
      pose_ = {x(random_), y(random_), 0.0};
    } while (world_->nearestObstacle(pose_.translation(), 0.2));
  }

  sensing::Sweep sweep() {
    sensing::Sweep sweep = test::sweepIn(*world_, pose_, 4.0);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    bool silent = false;
    for (sensing::Beam& beam : sweep.beams) {
      silent = chance(random_) < (silent ? 0.1 : 0.01) ? !silent : silent;
      beam.end *= 1.0 + noise(random_);
      beam.kind = silent ? sensing::BeamKind::kUnknown : beam.kind;
    }
    return sweep;
  }

  void walk() {
    std::uniform_real_distribution<double> turn(-1.0, 1.0);
    for (int attempt = 0; attempt < 30; ++attempt) {
      const Pose2 next = pose_ * Pose2{0.3, 0.0, turn(random_) * (1 + attempt / 5)};
      if (!world_->nearestObstacle(next.translation(), 0.15)) {
        pose_ = next;
        return;
      }
    }
    pose_.theta += 0.7;
  }

  [[nodiscard]] const Pose2& pose() const { return pose_; }

 private:
  std::mt19937_64 random_;
  std::shared_ptr<const simulation::World> world_;
  Pose2 pose_;
};

TEST(Detectors, TheFastOneFindsWhatASearchOfTheWholeMapFinds) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    RandomRun run(seed);
    mapping::OccupancyMapper mapper;
    FastDetector fast;
    for (int step = 0; step < 40; ++step) {
      SCOPED_TRACE(step);
      const sensing::Sweep sweep = run.sweep();
      ASSERT_EQ(mapper.add(sweep, run.pose()), "");
      const grid::OccupancyGrid map = mapper.render();
      const MapView view(map);
      fast.update(view, contourOf(sweep, run.pose(), view, 1));
      const auto everything = clusterFrontiers(allFrontierCells(view), view);
      ASSERT_EQ(shapesOf(listOf(fast.store())), shapesOf(everything));
      run.walk();
    }
  }
}

/// The wavefront stops where noise has cut open cells off from the robot, which is rare where
/// frontiers are long: of 100 seeds, 36 of 28849 were not reached, most of them at the first
/// sweeps.
TEST(Detectors, BothFindTheSameSet) {
  int long_ones = 0;
  int unreached = 0;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    RandomRun run(seed);
    mapping::OccupancyMapper mapper;
    FastDetector fast;
    for (int step = 0; step < 40; ++step) {
      SCOPED_TRACE(step);
      const sensing::Sweep sweep = run.sweep();
      ASSERT_EQ(mapper.add(sweep, run.pose()), "");
      const grid::OccupancyGrid map = mapper.render();
      const MapView view(map);
      fast.update(view, contourOf(sweep, run.pose(), view, 1));
      const auto wavefront = detectByWavefront(view, run.pose().translation(), 0.2);
      std::set<FrontierId> reached;  // which the fast detector must have, too
      for (const Frontier& frontier : wavefront) {
        for (const Cell& cell : frontier.cells) {
          ASSERT_NE(fast.store().ownerOf(cell), 0U) << cell.transpose();
          reached.insert(fast.store().ownerOf(cell));
        }
      }
      for (const auto& [id, frontier] : fast.store().all()) {
        long_ones += frontier.size >= 1.0 ? 1 : 0;
        unreached += frontier.size >= 1.0 && reached.count(id) == 0 ? 1 : 0;
      }
      run.walk();
    }
  }
  EXPECT_GT(long_ones, 0);
  EXPECT_LE(100 * unreached, long_ones) << unreached << " of " << long_ones;
}

TEST(Detectors, IdsOfFrontiersThatNothingHasHappenedToStay) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    RandomRun run(seed);
    mapping::OccupancyMapper mapper;
    FastDetector fast;
    std::map<Cells, FrontierId> before;
    for (int step = 0; step < 30; ++step) {
      const sensing::Sweep sweep = run.sweep();
      ASSERT_EQ(mapper.add(sweep, run.pose()), "");
      const grid::OccupancyGrid map = mapper.render();
      const MapView view(map);
      fast.update(view, contourOf(sweep, run.pose(), view, 1));
      std::map<Cells, FrontierId> now;
      for (const Frontier& frontier : listOf(fast.store())) {
        now[*shapesOf({frontier}).begin()] = frontier.id;
      }
      for (const auto& [shape, id] : now) {
        if (const auto old = before.find(shape); old != before.end()) {
          EXPECT_EQ(id, old->second);
        }
      }
      before = now;
      run.walk();
    }
  }
}

}  // namespace
}  // namespace omega_slam::exploration
