#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "omega_slam/mapping/map_raster.h"
#include "omega_slam/mapping/map_update.h"
#include "support/seeds.h"

namespace omega_slam::mapping {
namespace {

using geometry::Pose2;

/// Random sweeps, a quarter of them in the same places, so that cells are hit and passed by many.
class MapUpdateProperty : public ::testing::TestWithParam<RendererKind> {
 protected:
  std::vector<PlacedSweep> randomSweeps(int count) {
    std::vector<PlacedSweep> sweeps;
    for (int k = 0; k < count; ++k) {
      sweeps.push_back({static_cast<SweepId>(3 * k), randomSweep(), randomPose(4.0)});
    }
    return sweeps;
  }

  std::shared_ptr<const sensing::Sweep> randomSweep() {
    sensing::Sweep sweep;
    sweep.T_base_laser = {0.1, 0.02, angle_(random_)};
    sweep.angle_increment = 0.1;
    double range = 2.0;
    for (int beam = 0; beam < 60; ++beam) {
      range = std::clamp(range + 0.3 * unit_(random_), 0.3, 6.0);
      const double bearing = beam * sweep.angle_increment;
      sweep.beams.push_back({sweep.T_base_laser * Eigen::Vector2d(range * std::cos(bearing),
                                                                  range * std::sin(bearing)),
                             static_cast<sensing::BeamKind>(kind_(random_))});
    }
    return std::make_shared<const sensing::Sweep>(sweep);
  }

  Pose2 randomPose(double spread) {
    return {spread * unit_(random_), spread * unit_(random_), angle_(random_)};
  }

  [[nodiscard]] OccupancyMapperConfig config() const {
    OccupancyMapperConfig config;
    config.renderer.kind = GetParam();
    return config;
  }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> unit_{-1.0, 1.0};
  std::uniform_real_distribution<double> angle_{-3.1, 3.1};
  std::discrete_distribution<int> kind_{1, 8, 1};
};

std::size_t tilesOf(const CountTiles& tiles) {
  std::size_t count = 0;
  tiles.forEach([&count](const TileIndex&, const auto& tile) { count += tile ? 1U : 0U; });
  return count;
}

/// Every count of every cell, not only what is shown of them.
void expectSameCounts(const MapSnapshot& a, const MapSnapshot& b) {
  ASSERT_EQ(tilesOf(a.tiles), tilesOf(b.tiles));
  a.tiles.forEach([&b](const TileIndex& index, const auto& tile) {
    const auto& other = b.tiles.at(index);
    ASSERT_EQ(tile == nullptr, other == nullptr);
    if (!tile) {
      return;
    }
    EXPECT_EQ(tile->seen, other->seen);
    EXPECT_EQ(tile->vacated, other->vacated);
    const auto same = [](const CellCounts& x, const CellCounts& y) {
      return x.hits == y.hits && x.misses == y.misses;
    };
    EXPECT_TRUE(std::equal(tile->counts.begin(), tile->counts.end(), other->counts.begin(), same));
  });
}

void putAll(OccupancyMapper& mapper, const std::vector<PlacedSweep>& sweeps) {
  for (const PlacedSweep& sweep : sweeps) {
    ASSERT_EQ(mapper.put(sweep), "");
  }
}

TEST_P(MapUpdateProperty, TheOrderOfSweepsDoesNotMatter) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    random_.seed(seed);
    std::vector<PlacedSweep> sweeps = randomSweeps(15);
    OccupancyMapper first(config());
    putAll(first, sweeps);
    std::shuffle(sweeps.begin(), sweeps.end(), random_);
    OccupancyMapper second(config());
    putAll(second, sweeps);
    expectSameCounts(first.snapshot(), second.snapshot());
  }
}

TEST_P(MapUpdateProperty, TakenOutAllIsExactlyAsBefore) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    random_.seed(seed);
    std::vector<PlacedSweep> sweeps = randomSweeps(20);
    std::shuffle(sweeps.begin(), sweeps.end(), random_);
    const std::vector<PlacedSweep> stay(sweeps.begin(), sweeps.begin() + 10);
    OccupancyMapper mapper(config());
    putAll(mapper, stay);
    const MapSnapshot before = mapper.snapshot();
    putAll(mapper, sweeps);
    std::shuffle(sweeps.begin(), sweeps.end(), random_);
    for (const PlacedSweep& sweep : sweeps) {
      mapper.takeOut(sweep.id);
    }
    EXPECT_EQ(tilesOf(mapper.snapshot().tiles), 0U);
    putAll(mapper, stay);
    expectSameCounts(mapper.snapshot(), before);
  }
}

TEST_P(MapUpdateProperty, AnUpdatedMapIsTheMapDrawnAtOnce) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    random_.seed(seed);
    std::vector<PlacedSweep> sweeps = randomSweeps(20);
    OccupancyMapper kept(config());
    MapRaster raster(MapLayer::kVerdict);
    // Some rounds move a few, some many; sweeps come and go.
    for (const double share : {0.0, 0.2, 0.1, 0.9, 0.3}) {
      for (PlacedSweep& sweep : sweeps) {
        if (std::abs(unit_(random_)) < share) {
          sweep.T_map_base = sweep.T_map_base * randomPose(0.5);
        }
      }
      sweeps.erase(sweeps.begin() + 3);
      sweeps.push_back({sweeps.back().id + 2, randomSweep(), randomPose(9.0)});
      EXPECT_TRUE(update(kept, sweeps).refusals.empty());
      OccupancyMapper fresh(config());
      putAll(fresh, sweeps);
      const MapSnapshot snapshot = kept.snapshot();
      expectSameCounts(snapshot, fresh.snapshot());
      raster.update(snapshot);
      MapRaster at_once(MapLayer::kVerdict);
      at_once.update(fresh.snapshot());
      ASSERT_EQ(raster.grid().cells, at_once.grid().cells);
      ASSERT_EQ(raster.grid().geometry.origin, at_once.grid().geometry.origin);
      ASSERT_EQ(raster.grid().geometry.width, at_once.grid().geometry.width);
    }
  }
}

TEST_P(MapUpdateProperty, ARasterSaysWhatHasChanged) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    random_.seed(seed);
    OccupancyMapper mapper(config());
    putAll(mapper, randomSweeps(6));
    MapRaster raster(MapLayer::kProbability);
    EXPECT_TRUE(raster.update(mapper.snapshot()).is_resized);
    EXPECT_TRUE(raster.update(mapper.snapshot()).cells.isEmpty());
    const grid::OccupancyGrid before = raster.grid();
    ASSERT_EQ(mapper.put({100, randomSweep(), {}}), "");
    const RasterChange change = raster.update(mapper.snapshot());
    if (change.is_resized) {
      continue;
    }
    for (int y = 0; y < before.geometry.height; ++y) {
      for (int x = 0; x < before.geometry.width; ++x) {
        if (!change.cells.contains(grid::Cell(x, y))) {
          ASSERT_EQ(raster.grid().at({x, y}), before.at({x, y}));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Renderers, MapUpdateProperty,
                         ::testing::Values(RendererKind::kBeam, RendererKind::kTriangle),
                         [](const auto& renderer) {
                           return renderer.param == RendererKind::kBeam ? "Beam" : "Triangle";
                         });

}  // namespace
}  // namespace omega_slam::mapping
