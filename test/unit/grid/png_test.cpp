#include "omega_slam/grid/png.h"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

#include "omega_slam/grid/picture.h"

namespace omega_slam::grid {
namespace {

using testing::ElementsAre;

TEST(Png, ComesBackAsItWas) {
  GrayImage image{3, 2, {0, 1, 2, 253, 254, 255}, {}};
  EXPECT_EQ(decodePicture(encodePng(image)).pixels, image.pixels);
  image.opacity = {255, 0, 255, 0, 9, 255};
  const GrayImage again = decodePicture(encodePng(image));
  EXPECT_EQ(again.pixels, image.pixels);
  EXPECT_EQ(again.opacity, image.opacity);
}

TEST(Png, RowsMayLieApart) {
  const std::array<std::uint8_t, 8> bytes{1, 2, 99, 99, 3, 4, 99, 99};
  const GrayImage image = decodePicture(encodePng({2, 2, PixelFormat::kGrey, bytes.data(), 4}));
  EXPECT_THAT(image.pixels, ElementsAre(1, 2, 3, 4));
}

TEST(Png, OfNoPixelsIsNone) {
  EXPECT_THROW((void)encodePng(GrayImage{}), std::runtime_error);
  EXPECT_THROW((void)encodePng({0, 2, PixelFormat::kGrey, nullptr, 0}), std::runtime_error);
}

}  // namespace
}  // namespace omega_slam::grid
