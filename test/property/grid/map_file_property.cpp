#include <gtest/gtest.h>

#include <random>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_file.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

/// @param least -1: with unknown cells
OccupancyGrid randomMap(std::mt19937_64& random, int least) {
  std::uniform_int_distribution<int> size(1, 60);
  std::uniform_real_distribution<double> place(-1000.0, 1000.0);
  std::uniform_real_distribution<double> resolution(0.001, 1.0);
  std::uniform_int_distribution<int> value(least, 100);
  OccupancyGrid map = makeGrid(
      {resolution(random), {place(random), place(random)}, size(random), size(random)}, kUnknown);
  for (std::int8_t& cell : map.cells) {
    cell = static_cast<std::int8_t>(value(random));
  }
  return map;
}

/// As trinary files have them.
OccupancyGrid withThreeValues(OccupancyGrid map) {
  for (std::int8_t& cell : map.cells) {
    cell = cell < 0 ? kUnknown : (cell < 50 ? kFree : kOccupied);
  }
  return map;
}

std::vector<MapFormat> allFormats() {
  std::vector<MapFormat> formats;
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale, MapMode::kRaw}) {
    for (const ImageKind image : {ImageKind::kPgm, ImageKind::kPng}) {
      formats.push_back({mode, image});
    }
  }
  return formats;
}

void expectSame(const OccupancyGrid& loaded, const OccupancyGrid& map) {
  EXPECT_EQ(loaded.cells, map.cells);
  EXPECT_EQ(loaded.geometry.width, map.geometry.width);
  EXPECT_EQ(loaded.geometry.height, map.geometry.height);
  EXPECT_EQ(loaded.geometry.resolution, map.geometry.resolution);  // to the bit
  EXPECT_EQ(loaded.geometry.origin, map.geometry.origin);
}

TEST(MapFileProperty, SavingAndLoadingGivesTheSameMap) {
  const test::TemporaryFolder folder;
  const char* const names[] = {"map", "two words", "a: b #c", "quote\"d", "\xc3\xa4.pgm", "-"};
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (const char* name : names) {
      for (const MapFormat& format : allFormats()) {
        SCOPED_TRACE(toString(format.mode) + ' ' + toString(format.image));
        OccupancyGrid map = randomMap(random, format.whyNot(true).empty() ? -1 : 0);
        map = format.mode == MapMode::kTrinary ? withThreeValues(map) : map;
        const SaveResult saved = saveMap(map, folder.path() / name, format);
        ASSERT_TRUE(saved.success) << saved.message;
        expectSame(toOccupancyGrid(loadMapImage(saved.paths.at(1))), map);
      }
    }
  }
}

TEST(MapFileProperty, SavedLoadedAndSavedAgainTheBytesAreTheSame) {
  const test::TemporaryFolder folder;
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (const MapFormat& format : allFormats()) {
      SCOPED_TRACE(toString(format.mode) + ' ' + toString(format.image));
      const OccupancyGrid map = randomMap(random, format.whyNot(true).empty() ? -1 : 0);
      const SaveResult saved = saveMap(map, folder.path() / "map", format);
      ASSERT_TRUE(saved.success) << saved.message;
      const std::string image = readFile(saved.paths.at(0));
      const std::string yaml = readFile(saved.paths.at(1));
      const OccupancyGrid loaded = toOccupancyGrid(loadMapImage(saved.paths.at(1)));
      ASSERT_TRUE(saveMap(loaded, folder.path() / "map", format).success);
      EXPECT_EQ(readFile(saved.paths.at(0)), image);
      EXPECT_EQ(readFile(saved.paths.at(1)), yaml);
    }
  }
}

}  // namespace
}  // namespace omega_slam::grid
