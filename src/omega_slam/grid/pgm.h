#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace omega_slam::grid {

/// Grey values, row-major, row 0 at the top as in the file.
struct GrayImage {
  int width{0};
  int height{0};
  std::vector<std::uint8_t> pixels;
};

/// Images with more pixels than this are refused: at 5 cm a cell they would span 800 m by 800 m.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 28U;

/// Decodes a portable graymap, binary (P5) or plain (P2); any maximum up to 65535 is scaled to 255.
/// @throws std::runtime_error with a clause that says what is wrong ("the image is cut off: ...")
[[nodiscard]] GrayImage decodePgm(std::string_view bytes);

/// Encodes as binary PGM (P5, maximum 255) with one comment line.
/// @param comment one line, without line breaks
[[nodiscard]] std::string encodePgm(const GrayImage& image, const std::string& comment);

}  // namespace omega_slam::grid
