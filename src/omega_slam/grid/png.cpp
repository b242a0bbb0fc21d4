#include "omega_slam/grid/png.h"

#include <fmt/format.h>
#include <png.h>

#include <stdexcept>
#include <vector>

namespace omega_slam::grid {
namespace {

png_uint_32 libraryFormat(PixelFormat format) {
  switch (format) {
    case PixelFormat::kGrey:
      return PNG_FORMAT_GRAY;
    case PixelFormat::kGreyAlpha:
      return PNG_FORMAT_GA;
    case PixelFormat::kBlueGreenRed:
      break;
  }
  return PNG_FORMAT_BGR;
}

}  // namespace

std::string encodePng(const PixelRows& pixels) {
  if (pixels.width <= 0 || pixels.height <= 0) {
    throw std::runtime_error("an image without pixels can't be a PNG");
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = libraryFormat(pixels.format);
  image.flags = PNG_IMAGE_FLAG_FAST;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.first,
                                static_cast<png_int_32>(pixels.stride), nullptr) == 0) {
    throw std::runtime_error(fmt::format("the PNG library says: {}", image.message));
  }
  bytes.resize(size);
  return bytes;
}

std::string encodePng(const GrayImage& image) {
  const auto width = static_cast<std::size_t>(image.width);
  if (image.opacity.empty()) {
    return encodePng({image.width, image.height, PixelFormat::kGrey, image.pixels.data(), width});
  }
  std::vector<std::uint8_t> both;
  both.reserve(2 * image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    both.push_back(image.pixels[i]);
    both.push_back(image.opacity[i]);
  }
  return encodePng({image.width, image.height, PixelFormat::kGreyAlpha, both.data(), 2 * width});
}

}  // namespace omega_slam::grid
