#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "omega_slam/grid/ray_traversal.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "support/seeds.h"

namespace omega_slam::mapping {
namespace {

using geometry::Pose2;
using Shot = std::pair<sensing::Sweep, Pose2>;
using CellKey = std::pair<int, int>;

std::vector<Shot> randomShots(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  std::uniform_int_distribution<int> kind(0, 2);
  std::vector<Shot> shots;
  for (int k = 0; k < count; ++k) {
    sensing::Sweep sweep;
    sweep.T_base_laser = {0.1, 0.02, angle(random)};
    for (int beam = 0; beam < 40; ++beam) {
      sweep.beams.push_back(
          {{place(random), place(random)}, static_cast<sensing::BeamKind>(kind(random))});
    }
    shots.emplace_back(sweep, Pose2{place(random), place(random), angle(random)});
  }
  return shots;
}

grid::OccupancyGrid draw(const std::vector<Shot>& shots) {
  OccupancyMapper mapper;
  for (const Shot& shot : shots) {
    EXPECT_EQ(mapper.add(shot.first, shot.second), "");
  }
  return mapper.render();
}

/// The same map by sets and maps, without any care for speed.
std::map<CellKey, std::int8_t> oracle(const std::vector<Shot>& shots) {
  const grid::GridGeometry lattice{OccupancyMapperConfig().resolution, {0.0, 0.0}, 0, 0};
  std::map<CellKey, std::pair<int, int>> counts;
  for (const auto& [sweep, T_map_base] : shots) {
    const Eigen::Vector2d start = (T_map_base * sweep.T_base_laser).translation();
    std::set<CellKey> hits;
    std::set<CellKey> crossed;
    for (const sensing::Beam& beam : sweep.beams) {
      if (beam.kind == sensing::BeamKind::kUnknown) {
        continue;
      }
      CellKey last;
      grid::traverseRay(lattice, start, T_map_base * beam.end, [&](const grid::Cell& cell) {
        last = {cell.x(), cell.y()};
        crossed.insert(last);
      });
      if (beam.kind == sensing::BeamKind::kReturn) {
        hits.insert(last);
      }
    }
    for (const CellKey& cell : crossed) {
      ++(hits.count(cell) > 0 ? counts[cell].first : counts[cell].second);
    }
  }
  std::map<CellKey, std::int8_t> verdicts;
  for (const auto& [cell, count] : counts) {
    verdicts[cell] = count.first >= count.second ? grid::kOccupied : grid::kFree;
  }
  return verdicts;
}

TEST(OccupancyMapperProperty, AgreesWithTheSlowWay) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::vector<Shot> shots = randomShots(random, 6);
    const grid::OccupancyGrid map = draw(shots);
    const auto expected = oracle(shots);
    // The start is rounded once more on the way through cells, so that a beam that meets a border
    // to the last digit may take the other side: allow for one such in ten thousand.
    std::size_t differing = 0;
    std::size_t known = 0;
    const Eigen::Vector2d corner = map.geometry.origin / map.geometry.resolution;
    for (int y = 0; y < map.geometry.height; ++y) {
      for (int x = 0; x < map.geometry.width; ++x) {
        const CellKey key(x + static_cast<int>(std::lround(corner.x())),
                          y + static_cast<int>(std::lround(corner.y())));
        const auto found = expected.find(key);
        const std::int8_t value = found == expected.end() ? grid::kUnknown : found->second;
        differing += map.at({x, y}) != value ? 1U : 0U;
        known += map.at({x, y}) != grid::kUnknown ? 1U : 0U;
      }
    }
    EXPECT_LE(differing, known / 10000);
    EXPECT_NEAR(static_cast<double>(known), static_cast<double>(expected.size()),
                static_cast<double>(known) / 10000.0);
  }
}

TEST(OccupancyMapperProperty, OrderDoesNotMatter) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::vector<Shot> shots = randomShots(random, 12);
    const grid::OccupancyGrid first = draw(shots);
    for (int round = 0; round < 3; ++round) {
      std::shuffle(shots.begin(), shots.end(), random);
      const grid::OccupancyGrid again = draw(shots);
      ASSERT_EQ(again.cells, first.cells);
      ASSERT_EQ(again.geometry.origin, first.geometry.origin);
      ASSERT_EQ(again.geometry.width, first.geometry.width);
    }
  }
}

TEST(OccupancyMapperProperty, RepeatingEverySweepChangesNothing) {
  // Shares of hits stay what they are.
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::vector<Shot> shots = randomShots(random, 6);
    const grid::OccupancyGrid once = draw(shots);
    const std::vector<Shot> copy = shots;
    shots.insert(shots.end(), copy.begin(), copy.end());
    EXPECT_EQ(draw(shots).cells, once.cells);
  }
}

TEST(OccupancyMapperProperty, AShiftByWholeCellsShiftsTheMap) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    // Dyadic numbers and cells of 1/16 m make the shift exact.
    OccupancyMapperConfig config;
    config.resolution = 0.0625;
    std::uniform_int_distribution<int> place(-4096, 4096);
    sensing::Sweep sweep;
    for (int beam = 0; beam < 100; ++beam) {
      sweep.beams.push_back(
          {{place(random) / 1024.0, place(random) / 1024.0}, sensing::BeamKind::kReturn});
    }
    OccupancyMapper here(config);
    OccupancyMapper there(config);
    ASSERT_EQ(here.add(sweep, {0.0, 0.0, 0.0}), "");
    ASSERT_EQ(there.add(sweep, {1024.0, -512.0, 0.0}), "");
    EXPECT_EQ(there.render().cells, here.render().cells);
    EXPECT_EQ(there.render().geometry.origin,
              here.render().geometry.origin + Eigen::Vector2d(1024.0, -512.0));
  }
}

}  // namespace
}  // namespace omega_slam::mapping
