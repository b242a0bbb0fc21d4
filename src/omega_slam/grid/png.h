#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "omega_slam/grid/gray_image.h"

namespace omega_slam::grid {

/// What a pixel consists of, 8 bits each.
enum class PixelFormat : std::uint8_t { kGrey, kGreyAlpha, kBlueGreenRed };

/// Somebody else's pixels, row 0 at the top.
struct PixelRows {
  int width{0};
  int height{0};
  PixelFormat format{PixelFormat::kGrey};
  const std::uint8_t* first{nullptr};
  std::size_t stride{0};  ///< [bytes] from a row to the next
};

/// Encodes as PNG, for speed rather than for size. The same pixels give the same bytes.
/// @throws std::runtime_error with a clause that says what is wrong, as with an image of no pixels
[[nodiscard]] std::string encodePng(const PixelRows& pixels);

/// Grey, or with an alpha channel if the image has an opacity.
[[nodiscard]] std::string encodePng(const GrayImage& image);

}  // namespace omega_slam::grid
