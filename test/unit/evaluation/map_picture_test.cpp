#include "omega_slam/evaluation/map_picture.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"
#include "support/temporary_folder.h"

namespace omega_slam::evaluation {
namespace {

MapPicture room() {
  MapPicture picture;
  picture.map = grid::makeGrid({0.05, {-2.0, -1.0}, 80, 40}, grid::kUnknown);
  for (int y = 5; y < 35; ++y) {
    for (int x = 5; x < 75; ++x) {
      const bool edge = x == 5 || y == 5 || x == 74 || y == 34;
      picture.map.at({x, y}) = edge ? grid::kOccupied : grid::kFree;
    }
  }
  for (int k = 0; k <= 20; ++k) {
    picture.estimated_path.push_back({k * 0.1, {-1.0 + 0.1 * k, 0.02 * k - 0.5, 0.0}});
    picture.true_path.push_back({k * 0.1, {-1.0 + 0.1 * k, 0.0, 0.0}});
  }
  picture.caption = "room, 3.5 m by 1.5 m";
  return picture;
}

cv::Mat decoded(const MapPicture& picture) {
  const std::string bytes = encodeMapPicture(picture);
  return cv::imdecode(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), cv::IMREAD_COLOR);
}

std::size_t count(const cv::Mat& image, const cv::Vec3b& colour) {
  cv::Mat mask;
  cv::inRange(image, colour, colour, mask);
  return static_cast<std::size_t>(cv::countNonZero(mask));
}

TEST(MapPicture, IsOfAReadableSize) {
  const cv::Mat image = decoded(room());
  EXPECT_GE(image.cols, 1000);
  EXPECT_LE(image.cols, 1200);
  MapPicture wide = room();
  wide.map = grid::makeGrid({0.05, {0, 0}, 9000, 3}, grid::kFree);
  EXPECT_LE(decoded(wide).cols, 4100);
}

TEST(MapPicture, ShowsWallsAndPaths) {
  const cv::Mat image = decoded(room());
  const std::size_t wall_cells = 2 * 70 + 2 * 28;
  EXPECT_GT(count(image, {58, 46, 40}), wall_cells * 13 * 13 * 9 / 10);
  EXPECT_GT(count(image, {40, 96, 226}), 500U);   // estimated path
  EXPECT_GT(count(image, {178, 134, 44}), 500U);  // true path
}

TEST(MapPicture, TheUpperRowOfTheMapIsOnTop) {
  MapPicture picture = room();
  picture.estimated_path.clear();
  picture.true_path.clear();
  picture.map = grid::makeGrid({0.05, {0, 0}, 10, 10}, grid::kFree);
  picture.map.at({9, 9}) = grid::kOccupied;
  const cv::Mat image = decoded(picture);
  EXPECT_EQ(image.at<cv::Vec3b>(80, 30 + 950), cv::Vec3b(58, 46, 40));
  EXPECT_EQ(image.at<cv::Vec3b>(80, 80), cv::Vec3b(255, 255, 255));
}

TEST(MapPicture, ThinWallsSurviveReduction) {
  MapPicture picture;
  picture.map = grid::makeGrid({0.05, {0, 0}, 9000, 9}, grid::kFree);
  for (int x = 0; x < 9000; ++x) {
    picture.map.at({x, 4}) = grid::kOccupied;
  }
  EXPECT_GE(count(decoded(picture), {58, 46, 40}), 4000U);
}

TEST(MapPicture, SameInputSameBytes) {
  EXPECT_EQ(encodeMapPicture(room()), encodeMapPicture(room()));
}

TEST(MapPicture, PathsMayLeaveTheMapAndBeOfOnePose) {
  MapPicture picture = room();
  picture.estimated_path = {{0.0, {1e9, -1e9, 0.0}}};
  picture.true_path = {{0.0, {0, 0, 0}}, {1.0, {std::nan(""), 0, 0}}, {2.0, {50, 50, 0}}};
  EXPECT_FALSE(decoded(picture).empty());
}

TEST(MapPicture, AMapWithoutCellsHasNone) {
  EXPECT_THROW(static_cast<void>(encodeMapPicture({})), std::invalid_argument);
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "map.png";
  EXPECT_EQ(writeMapPicture(path, {}),
            path.string() + " could not be written: a map without cells has no picture.");
  EXPECT_EQ(writeMapPicture(path, room()), "");
  EXPECT_EQ(grid::readFile(path), encodeMapPicture(room()));
}

}  // namespace
}  // namespace omega_slam::evaluation
