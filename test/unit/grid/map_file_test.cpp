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

TEST(MapFile, SavesScaleAsPngWithUnknownCellsTransparent) {
  const test::TemporaryFolder folder;
  const OccupancyGrid map{{0.05, {-1.25, 3.0}, 2, 2}, {0, 37, -1, 100}};
  const SaveResult saved = saveMap(map, folder.path() / "map", {MapMode::kScale, ImageKind::kPng});
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.paths[0].filename(), "map.png");
  EXPECT_EQ(readFile(saved.paths[1]),
            "image: \"map.png\"\nresolution: 0.05\norigin: [-1.25, 3, 0]\nnegate: 0\n"
            "occupied_thresh: 0.996078431372549\nfree_thresh: 0.00196078431372549\n"
            "mode: scale\n");
  const cv::Mat picture = cv::imread(saved.paths[0].string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(picture.channels(), 4);
  EXPECT_EQ(picture.at<cv::Vec4b>(1, 0), cv::Vec4b(255, 255, 255, 255));  // lower left: free
  EXPECT_EQ(picture.at<cv::Vec4b>(0, 0)[3], 0);
  EXPECT_EQ(picture.at<cv::Vec4b>(0, 1), cv::Vec4b(0, 0, 0, 255));
  EXPECT_EQ(toOccupancyGrid(loadMapImage(saved.paths[1])).cells, map.cells);
}

TEST(MapFile, SavesRawCells) {
  const test::TemporaryFolder folder;
  const OccupancyGrid map{{0.05, {0.0, 0.0}, 4, 1}, {0, 37, -1, 100}};
  const SaveResult saved = saveMap(map, folder.path() / "map", {MapMode::kRaw, ImageKind::kPgm});
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(readFile(saved.paths[0]),
            "P5\n# 0.05 m/pix\n4 1\n255\n" + std::string("\x00\x25\xff\x64", 4));
  EXPECT_THAT(readFile(saved.paths[1]), HasSubstr("mode: raw\n"));
}

TEST(MapFile, SavesNoUnknownCellsWithScaleInAPgm) {
  const test::TemporaryFolder folder;
  OccupancyGrid map{{0.05, {0.0, 0.0}, 2, 1}, {0, -1}};
  const MapFormat format{MapMode::kScale, ImageKind::kPgm};
  const SaveResult refused = saveMap(map, folder.path() / "map", format);
  EXPECT_FALSE(refused.success);
  EXPECT_THAT(refused.message, HasSubstr("transparent pixels, which a PGM does not have"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  map.cells[1] = 50;
  EXPECT_TRUE(saveMap(map, folder.path() / "map", format).success);
}

TEST(MapFile, FormatsHaveNames) {
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale, MapMode::kRaw}) {
    EXPECT_EQ(mapModeFromName(toString(mode)), mode);
  }
  for (const ImageKind kind : {ImageKind::kPgm, ImageKind::kPng}) {
    EXPECT_EQ(imageKindFromName(toString(kind)), kind);
  }
  EXPECT_FALSE(mapModeFromName("quad"));
  EXPECT_FALSE(imageKindFromName("PNG"));
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
