#include <gtest/gtest.h>

#include <random>

#include "omega_slam/grid/map_file.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

OccupancyGrid randomMap(std::mt19937_64& random) {
  std::uniform_int_distribution<int> size(1, 60);
  std::uniform_real_distribution<double> place(-1000.0, 1000.0);
  std::uniform_real_distribution<double> resolution(0.001, 1.0);
  std::uniform_int_distribution<int> kind(0, 2);
  constexpr std::int8_t kValues[] = {kFree, kOccupied, kUnknown};
  OccupancyGrid map = makeGrid(
      {resolution(random), {place(random), place(random)}, size(random), size(random)}, kUnknown);
  for (std::int8_t& cell : map.cells) {
    cell = kValues[kind(random)];
  }
  return map;
}

TEST(MapFileProperty, SavingAndLoadingGivesTheSameMap) {
  const test::TemporaryFolder folder;
  const char* const names[] = {"map", "two words", "a: b #c", "quote\"d", "\xc3\xa4.pgm", "-"};
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (const char* name : names) {
      const OccupancyGrid map = randomMap(random);
      const SaveResult saved = saveMap(map, folder.path() / name);
      ASSERT_TRUE(saved.success) << saved.message;
      const OccupancyGrid loaded = toOccupancyGrid(loadMapImage(saved.paths.at(1)));
      EXPECT_EQ(loaded.cells, map.cells);
      EXPECT_EQ(loaded.geometry.width, map.geometry.width);
      EXPECT_EQ(loaded.geometry.height, map.geometry.height);
      EXPECT_EQ(loaded.geometry.resolution, map.geometry.resolution);  // to the bit
      EXPECT_EQ(loaded.geometry.origin, map.geometry.origin);
    }
  }
}

}  // namespace
}  // namespace omega_slam::grid
