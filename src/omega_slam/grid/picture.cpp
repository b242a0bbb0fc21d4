#include "omega_slam/grid/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string_view>

namespace omega_slam::grid {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

std::uint64_t bigEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes.substr(0, 4)) {
    value = value * 256 + static_cast<unsigned char>(byte);
  }
  return value;
}

std::runtime_error cutOff() {
  return std::runtime_error("the image is cut off: it does not go on to the end that a PNG has");
}

/// Goes from chunk to chunk (length, name, content, checksum) to the end.
void checkPng(std::string_view bytes) {
  constexpr std::size_t kFrame = 12;  // bytes of a chunk beside its content
  bytes.remove_prefix(kPngSignature.size());
  if (bytes.size() < kFrame + 8) {
    throw cutOff();
  }
  const std::uint64_t width = bigEndian(bytes.substr(8));
  const std::uint64_t height = bigEndian(bytes.substr(12));
  if (width * height == 0 || width * height > kMaxPixels) {
    throw std::runtime_error(fmt::format("a size of {} x {} pixels is not usable", width, height));
  }
  for (;;) {
    if (bytes.size() < kFrame || bigEndian(bytes) > bytes.size() - kFrame) {
      throw cutOff();
    }
    if (bytes.substr(4, 4) == "IEND") {
      return;
    }
    bytes.remove_prefix(kFrame + bigEndian(bytes));
  }
}

cv::Mat decode(const std::string& bytes) {
  cv::Mat picture;
  if (!bytes.empty()) {
    try {
      picture =
          cv::imdecode(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
      picture.release();
    }
  }
  if (picture.empty() || (picture.depth() != CV_8U && picture.depth() != CV_16U)) {
    throw std::runtime_error("it is no image, or a damaged one");
  }
  if (picture.depth() == CV_16U) {
    picture.convertTo(picture, CV_8U, 1.0 / 257.0);
  }
  return picture;
}

}  // namespace

GrayImage decodePicture(const std::string& bytes) {
  if (std::string_view(bytes).substr(0, kPngSignature.size()) == kPngSignature) {
    checkPng(bytes);
  }
  const cv::Mat picture = decode(bytes);
  const int channels = picture.channels();
  const int colours = channels == 4 || channels == 2 ? channels - 1 : channels;
  GrayImage image{picture.cols, picture.rows, {}, {}};
  for (int row = 0; row < picture.rows; ++row) {
    const std::uint8_t* value = picture.ptr<std::uint8_t>(row);
    for (int col = 0; col < picture.cols; ++col, value += channels) {
      int sum = 0;
      for (int k = 0; k < colours; ++k) {
        sum += value[k];
      }
      image.pixels.push_back(static_cast<std::uint8_t>((sum + colours / 2) / colours));
      if (colours < channels) {
        image.opacity.push_back(value[colours]);
      }
    }
  }
  return image;
}

}  // namespace omega_slam::grid
