#include "omega_slam/grid/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace omega_slam::grid {
namespace {

using ::testing::ElementsAre;

std::string png(const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", picture, bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(Picture, ColoursAreAveraged) {
  const GrayImage image = decodePicture(png(cv::Mat(1, 1, CV_8UC3, cv::Scalar(10, 20, 60))));
  EXPECT_THAT(image.pixels, ElementsAre(30));
  EXPECT_TRUE(image.opacity.empty());
}

TEST(Picture, AlphaIsNoColour) {
  const GrayImage image = decodePicture(png(cv::Mat(1, 1, CV_8UC4, cv::Scalar(10, 20, 60, 7))));
  EXPECT_THAT(image.pixels, ElementsAre(30));
  EXPECT_THAT(image.opacity, ElementsAre(7));
}

TEST(Picture, SixteenBitsBecomeEight) {
  cv::Mat picture(1, 3, CV_16UC1);
  picture.at<std::uint16_t>(0, 0) = 0;
  picture.at<std::uint16_t>(0, 1) = 128 * 257;
  picture.at<std::uint16_t>(0, 2) = 65535;
  EXPECT_THAT(decodePicture(png(picture)).pixels, ElementsAre(0, 128, 255));
}

TEST(Picture, ReadsOtherKindsThanPng) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".bmp", cv::Mat(2, 3, CV_8UC1, cv::Scalar(99)), bytes);
  const GrayImage image = decodePicture({bytes.begin(), bytes.end()});
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(image.pixels, testing::Each(99));
}

}  // namespace
}  // namespace omega_slam::grid
