#include "omega_slam/grid/map_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace omega_slam::grid {
namespace {

using ::testing::ElementsAre;

MapImage row(std::vector<std::uint8_t> pixels, MapMode mode) {
  MapImage image;
  image.geometry.width = static_cast<int>(pixels.size());
  image.geometry.height = 1;
  image.pixels = std::move(pixels);
  image.mode = mode;
  return image;
}

TEST(MapImage, ThresholdsAreExclusive) {
  MapImage image = row({100, 200, 201}, MapMode::kTrinary);
  image.occupied_threshold = 200 / 255.0;
  image.free_threshold = 100 / 255.0;
  image.negate = true;
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(-1, -1, 100));
}

TEST(MapImage, ModesAreThoseOfMapServer) {
  const std::vector<std::uint8_t> pixels = {255, 150, 100, 0};
  EXPECT_THAT(toOccupancyGrid(row(pixels, MapMode::kTrinary)).cells, ElementsAre(0, -1, -1, 100));
  // 1 + 98 * (105 / 255 - 0.196) / (0.65 - 0.196) = 47.6 and 1 + 98 * (155 / 255 - ...) = 89.9
  EXPECT_THAT(toOccupancyGrid(row(pixels, MapMode::kScale)).cells, ElementsAre(0, 47, 89, 100));
  EXPECT_THAT(toOccupancyGrid(row(pixels, MapMode::kRaw)).cells, ElementsAre(-1, -1, 100, 0));
}

TEST(MapImage, RawIsNegatedToo) {
  MapImage image = row({255, 155, 154, 0}, MapMode::kRaw);
  image.negate = true;
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(0, 100, -1, -1));
}

TEST(MapImage, ATransparentPixelIsUnknownOnlyWithScaleAndBetweenTheThresholds) {
  MapImage image = row({255, 150, 150, 0}, MapMode::kScale);
  image.opacity = {0, 0, 1, 0};
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(0, -1, 47, 100));
  image.mode = MapMode::kRaw;
  image.pixels = {20, 30, 40, 50};
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(20, 30, 40, 50));
}

TEST(MapImage, ScaleAndRawKeepEveryCell) {
  OccupancyGrid map{{0.1, {-2.0, 3.0}, 102, 1}, {}};
  for (int cell = -1; cell <= 100; ++cell) {
    map.cells.push_back(static_cast<std::int8_t>(cell));
  }
  for (const MapMode mode : {MapMode::kScale, MapMode::kRaw}) {
    EXPECT_EQ(toOccupancyGrid(toMapImage(map, mode)).cells, map.cells) << toString(mode);
  }
}

TEST(MapImage, WhatIsNoCellIsWrittenAsUnknown) {
  const OccupancyGrid map{{0.1, {0.0, 0.0}, 3, 1}, {101, -2, 127}};
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale, MapMode::kRaw}) {
    EXPECT_THAT(toOccupancyGrid(toMapImage(map, mode)).cells, ElementsAre(-1, -1, -1))
        << toString(mode);
  }
}

TEST(MapImage, OnlyUnknownCellsNeedAnOpacity) {
  EXPECT_TRUE(toMapImage({{0.1, {0.0, 0.0}, 2, 1}, {0, 50}}, MapMode::kScale).opacity.empty());
  EXPECT_THAT(toMapImage({{0.1, {0.0, 0.0}, 2, 1}, {0, -1}}, MapMode::kScale).opacity,
              ElementsAre(255, 0));
  EXPECT_TRUE(toMapImage({{0.1, {0.0, 0.0}, 2, 1}, {0, -1}}, MapMode::kRaw).opacity.empty());
}

}  // namespace
}  // namespace omega_slam::grid
