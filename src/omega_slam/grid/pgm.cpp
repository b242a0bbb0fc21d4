#include "omega_slam/grid/pgm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace omega_slam::grid {
namespace {

/// Walks over the bytes of a PGM file.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }
  [[nodiscard]] unsigned byte() { return static_cast<unsigned char>(bytes_[position_++]); }

  /// Whether nothing but white space is left.
  [[nodiscard]] bool isBlank() const {
    return std::all_of(bytes_.begin() + static_cast<std::ptrdiff_t>(position_), bytes_.end(),
                       [](unsigned char byte) { return std::isspace(byte) != 0; });
  }

  /// Next decimal number, past white space and comments.
  /// @param what for the message where there is none
  unsigned number(const char* what) {
    skipBlanks();
    constexpr unsigned kLimit = 1U << 30U;  // no width, height or grey value is larger
    unsigned value = 0;
    const std::size_t start = position_;
    while (left() > 0 && std::isdigit(peek()) != 0 && value < kLimit) {
      value = value * 10U + byte() - '0';
    }
    if (position_ == start) {
      throw std::runtime_error(fmt::format("{} is missing or not a number", what));
    }
    if (value >= kLimit) {
      throw std::runtime_error(fmt::format("{} is absurdly large", what));
    }
    return value;
  }

 private:
  [[nodiscard]] int peek() const { return static_cast<unsigned char>(bytes_[position_]); }

  void skipBlanks() {
    while (left() > 0 && (std::isspace(peek()) != 0 || peek() == '#')) {
      if (peek() == '#') {
        position_ = std::min(bytes_.find('\n', position_), bytes_.size());
      } else {
        ++position_;
      }
    }
  }

  std::string_view bytes_;
  std::size_t position_{0};
};

/// Before anything is allocated: are there bytes enough for what the header promises?
void checkSize(const Cursor& cursor, std::uint64_t needed_bytes) {
  if (cursor.left() < needed_bytes) {
    throw std::runtime_error(
        fmt::format("the image is cut off: its header promises at least {} bytes of pixels and {} "
                    "are there",
                    needed_bytes, cursor.left()));
  }
}

/// More bytes than pixels: the size is not that of the image. Blanks at the end are an editor's.
void checkEnd(const Cursor& cursor) {
  if (!cursor.isBlank()) {
    throw std::runtime_error(fmt::format(
        "after the pixels that its header promises {} bytes are left: the size is wrong",
        cursor.left()));
  }
}

std::uint8_t scaled(unsigned value, unsigned maximum) {
  if (value > maximum) {
    throw std::runtime_error(fmt::format(
        "a pixel of {} is above the maximum {} that the header states", value, maximum));
  }
  return static_cast<std::uint8_t>((value * 255U + maximum / 2U) / maximum);
}

}  // namespace

GrayImage decodePgm(std::string_view bytes) {
  const std::string_view magic = bytes.substr(0, 2);
  if (magic != "P5" && magic != "P2") {
    throw std::runtime_error("the image is no PGM: it starts neither with P5 nor with P2");
  }
  Cursor cursor(bytes.substr(2));
  const unsigned width = cursor.number("the width");
  const unsigned height = cursor.number("the height");
  const unsigned maximum = cursor.number("the maximum grey value");
  const std::uint64_t count = std::uint64_t{width} * height;
  if (count == 0 || count > kMaxPixels) {
    throw std::runtime_error(fmt::format("a size of {} x {} pixels is not usable", width, height));
  }
  if (maximum == 0 || maximum > 65535) {
    throw std::runtime_error(fmt::format("a maximum grey value of {} is not allowed", maximum));
  }
  const bool binary = magic == "P5";
  const bool wide = maximum > 255;
  // Plain pixels take a digit and a blank each, the last one perhaps no blank; in front of binary
  // ones stands a single blank.
  checkSize(cursor, binary ? 1 + count * (wide ? 2 : 1) : 2 * count);
  GrayImage image{static_cast<int>(width), static_cast<int>(height), {}, {}};
  image.pixels.reserve(count);
  if (binary) {
    static_cast<void>(cursor.byte());
  }
  for (std::uint64_t pixel = 0; pixel < count; ++pixel) {
    unsigned value = binary ? cursor.byte() : cursor.number("a pixel");
    if (binary && wide) {
      value = value * 256U + cursor.byte();
    }
    image.pixels.push_back(scaled(value, maximum));
  }
  checkEnd(cursor);
  return image;
}

std::string encodePgm(const GrayImage& image, const std::string& comment) {
  std::string bytes = fmt::format("P5\n# {}\n{} {}\n255\n", comment, image.width, image.height);
  bytes.append(image.pixels.begin(), image.pixels.end());
  return bytes;
}

}  // namespace omega_slam::grid
