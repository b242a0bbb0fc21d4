#pragma once

#include <string>

#include "omega_slam/grid/gray_image.h"

namespace omega_slam::grid {

/// Decodes an image file of any kind that OpenCV reads. Grey is the mean of the colours, rounded;
/// 16 bits become 8. A PNG is looked through first, so that a cut one, or one of absurd size, is
/// recognised before anything is allocated.
/// @throws std::runtime_error with a clause that says what is wrong ("the image is cut off: ...")
[[nodiscard]] GrayImage decodePicture(const std::string& bytes);

}  // namespace omega_slam::grid
