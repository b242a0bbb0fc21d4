#pragma once

#include <string>
#include <string_view>

#include "omega_slam/grid/gray_image.h"

namespace omega_slam::grid {

/// Decodes a portable graymap, binary (P5) or plain (P2); any maximum up to 65535 is scaled to 255.
/// @throws std::runtime_error with a clause that says what is wrong ("the image is cut off: ...")
[[nodiscard]] GrayImage decodePgm(std::string_view bytes);

/// Encodes as binary PGM (P5, maximum 255) with one comment line.
/// @param comment one line, without line breaks
[[nodiscard]] std::string encodePgm(const GrayImage& image, const std::string& comment);

}  // namespace omega_slam::grid
