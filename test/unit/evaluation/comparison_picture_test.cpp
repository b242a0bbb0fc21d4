#include "omega_slam/evaluation/comparison_picture.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"
#include "support/drawn_map.h"
#include "support/temporary_folder.h"

namespace omega_slam::evaluation {
namespace {

const grid::OccupancyGrid kTruth = test::drawnMap({
    "############",
    "#........#.#",
    "#........#.#",
    "############",
});
const grid::OccupancyGrid kBuilt = test::drawnMap({
    "##??########",
    "#..#?????#.#",
    "#........#?#",
    "############",
});

ComparisonPicture picture(const geometry::Pose2& T_truth_map = {}) {
  ComparisonPicture picture{kBuilt, kTruth, T_truth_map, {}, "two maps"};
  ResemblanceOptions strict;
  strict.wall_tolerance = 0;
  picture.comparison = judgeMaps(kBuilt, kTruth, {T_truth_map, std::nullopt}, strict);
  return picture;
}

cv::Mat decoded(const ComparisonPicture& picture) {
  const std::string bytes = encodeComparisonPicture(picture);
  return cv::imdecode(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), cv::IMREAD_COLOR);
}

int count(const cv::Mat& image, const cv::Vec3b& colour) {
  cv::Mat mask;
  cv::inRange(image, colour, colour, mask);
  return cv::countNonZero(mask);
}

TEST(ComparisonPicture, EachVerdictHasItsColour) {
  const cv::Mat image = decoded(picture());
  const int cell = 84 * 84;  // pixels: twelve columns make a thousand
  EXPECT_NEAR(count(image, {38, 38, 214}), 1 * cell, cell / 2);    // wall wrong
  EXPECT_NEAR(count(image, {196, 110, 20}), 2 * cell, cell / 2);   // wall missed
  EXPECT_NEAR(count(image, {60, 160, 245}), 1 * cell, cell / 2);   // open wrong
  EXPECT_NEAR(count(image, {245, 222, 190}), 5 * cell, cell / 2);  // open not seen
  EXPECT_NEAR(count(image, {58, 46, 40}), 28 * cell, cell / 2);    // wall right
}

TEST(ComparisonPicture, ShowsWhatLiesOutsideOfTheTruth) {
  const cv::Mat image = decoded(picture({0.0, 30.0, 0.0}));
  EXPECT_GT(count(image, {38, 38, 214}), 20 * 25 * 25);  // all built walls
  EXPECT_GT(image.rows, image.cols);
}

TEST(ComparisonPicture, RefusesWhatNoPictureShows) {
  EXPECT_THROW(static_cast<void>(encodeComparisonPicture({})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(encodeComparisonPicture(picture({1e9, 0.0, 0.0}))),
               std::invalid_argument);
  ComparisonPicture other = picture();
  other.comparison.built.pop_back();
  EXPECT_THROW(static_cast<void>(encodeComparisonPicture(other)), std::invalid_argument);
}

TEST(ComparisonPicture, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(writeComparisonPicture(folder.path() / "a.png", picture()), "");
  EXPECT_EQ(grid::readFile(folder.path() / "a.png"), encodeComparisonPicture(picture()));
  EXPECT_NE(writeComparisonPicture(folder.path() / "b.png", {}).find("b.png could not be written"),
            std::string::npos);
}

}  // namespace
}  // namespace omega_slam::evaluation
