#pragma once

#include <cstdint>
#include <vector>

namespace omega_slam::grid {

/// Grey values, row-major, row 0 at the top as in the file.
struct GrayImage {
  int width{0};
  int height{0};
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint8_t> opacity;  ///< of each pixel, 0: transparent; empty: all are opaque
};

/// The rows of an image in the opposite order: its first row is its top, that of a grid its bottom.
[[nodiscard]] inline std::vector<std::uint8_t> upsideDown(const std::vector<std::uint8_t>& values,
                                                          int width) {
  std::vector<std::uint8_t> result;
  result.reserve(values.size());
  for (auto end = values.end(); end != values.begin(); end -= width) {
    result.insert(result.end(), end - width, end);
  }
  return result;
}

/// Images with more pixels than this are refused: at 5 cm a cell they would span 800 m by 800 m.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 28U;

}  // namespace omega_slam::grid
