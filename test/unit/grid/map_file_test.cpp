#include "omega_slam/grid/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "omega_slam/grid/atomic_file.h"
#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string yamlText(const std::string& image, const std::string& more = "negate: 0\n") {
  return "image: " + image +
         "\nresolution: 0.1\norigin: [-1.5, 2.0, 0.0]\noccupied_thresh: 0.65\nfree_thresh: "
         "0.196\n" +
         more;
}

TEST(MapFile, ReadsPlainPgmBottomRowFirst) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", "P2\n# a comment\n3 2\n255\n0 205 254\n254 254 0\n");
  const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.pgm")));
  EXPECT_EQ(image.geometry.width, 3);
  EXPECT_EQ(image.geometry.height, 2);
  EXPECT_DOUBLE_EQ(image.geometry.resolution, 0.1);
  EXPECT_DOUBLE_EQ(image.geometry.origin.x(), -1.5);
  EXPECT_DOUBLE_EQ(image.geometry.origin.y(), 2.0);
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(0, 0, 100, 100, -1, 0));
}

TEST(MapFile, ReadsBinaryPgmWithSixteenBits) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", std::string("P5 2 1 65535\n") + std::string("\xff\xff\x00\x00", 4));
  const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.pgm")));
  EXPECT_THAT(image.pixels, ElementsAre(255, 0));
}

TEST(MapFile, ScalesAMaximumBelow255) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", "P2 3 1 15 0 15 7");
  const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.pgm")));
  EXPECT_THAT(image.pixels, ElementsAre(0, 255, 119));
}

TEST(MapFile, FirstBinaryPixelMayLookLikeABlank) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", std::string("P5\n2 1\n255\n\n#", 13));
  const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.pgm")));
  EXPECT_THAT(image.pixels, ElementsAre('\n', '#'));
}

TEST(MapFile, NegateSwapsBlackAndWhite) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", "P2 3 1 255 0 128 255");
  for (const char* yes : {"negate: 1\n", "negate: true\n"}) {
    const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.pgm", yes)));
    EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(0, -1, 100)) << yes;
  }
}

TEST(MapFile, ThresholdsAreExclusive) {
  MapImage image;
  image.geometry.width = 3;
  image.geometry.height = 1;
  image.occupied_threshold = 200 / 255.0;
  image.free_threshold = 100 / 255.0;
  image.negate = true;
  image.pixels = {100, 200, 201};
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(-1, -1, 100));
}

TEST(MapFile, ModesAreThoseOfMapServer) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", "P2 4 1 255 255 150 100 0");
  const auto cells = [&folder](const std::string& mode) {
    return toOccupancyGrid(
               loadMapImage(folder.write("m.yaml", yamlText("m.pgm", "negate: 0\n" + mode))))
        .cells;
  };
  EXPECT_THAT(cells("mode: trinary\n"), ElementsAre(0, -1, -1, 100));
  // (105 / 255 - 0.196) / (0.65 - 0.196) * 99 = 47.05 and (155 / 255 - 0.196) / ... = 89.8
  EXPECT_THAT(cells("mode: scale\n"), ElementsAre(0, 47, 89, 100));
  EXPECT_THAT(cells("mode: raw\n"), ElementsAre(-1, -1, 100, 0));
}

TEST(MapFile, ReadsOtherImagesThroughOpenCv) {
  const test::TemporaryFolder folder;
  cv::Mat picture(2, 2, CV_8UC1, cv::Scalar(254));
  picture.at<std::uint8_t>(0, 1) = 0;  // upper right
  cv::imwrite((folder.path() / "m.png").string(), picture);
  const MapImage image = loadMapImage(folder.write("m.yaml", yamlText("m.png")));
  EXPECT_THAT(toOccupancyGrid(image).cells, ElementsAre(0, 0, 0, 100));
}

TEST(MapFile, ImageMayBeAbsoluteOrInAnotherFolder) {
  const test::TemporaryFolder images;
  const test::TemporaryFolder folder;
  const auto image = images.write("m.pgm", "P2 1 1 255 0");
  EXPECT_EQ(loadMapImage(folder.write("m.yaml", yamlText(image.string()))).pixels.size(), 1U);
}

TEST(MapFile, SavesWhatMapServerReads) {
  const test::TemporaryFolder folder;
  OccupancyGrid map{{0.05, {-1.25, 3.0}, 3, 2}, {0, 100, -1, 25, 65, 50}};
  const SaveResult saved = saveMap(map, folder.path() / "new" / "map.v2");
  ASSERT_TRUE(saved.success) << saved.message;
  ASSERT_EQ(saved.paths.size(), 2U);
  EXPECT_EQ(saved.paths[0].filename(), "map.v2.pgm");
  EXPECT_EQ(saved.paths[1].filename(), "map.v2.yaml");
  EXPECT_THAT(saved.message, HasSubstr("3 x 2 cells"));
  EXPECT_EQ(readFile(saved.paths[0]),
            "P5\n# 0.05 m/pix\n3 2\n255\n" + std::string("\xfe\x00\xcd\xfe\x00\xcd", 6));
  EXPECT_EQ(readFile(saved.paths[1]),
            "image: \"map.v2.pgm\"\nresolution: 0.05\norigin: [-1.25, 3, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapFile, OverwritesAnOldMap) {
  const test::TemporaryFolder folder;
  OccupancyGrid map{{0.05, {0.0, 0.0}, 1, 1}, {0}};
  ASSERT_TRUE(saveMap(map, folder.path() / "map").success);
  map.cells[0] = 100;
  ASSERT_TRUE(saveMap(map, folder.path() / "map").success);
  EXPECT_THAT(toOccupancyGrid(loadMapImage(folder.path() / "map.yaml")).cells, ElementsAre(100));
}

}  // namespace
}  // namespace omega_slam::grid
