#include "omega_slam/evaluation/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::evaluation {
namespace {

// Colours are blue, green, red, as OpenCV has them.
const cv::Scalar kUnknownColour(214, 211, 208);
const cv::Scalar kFreeColour(255, 255, 255);
const cv::Scalar kWallColour(58, 46, 40);
const cv::Scalar kEstimateColour(40, 96, 226);
const cv::Scalar kTruthColour(178, 134, 44);
const cv::Scalar kStartColour(84, 150, 38);
const cv::Scalar kInkColour(70, 62, 56);

constexpr int kLeastSize = 1000;
constexpr int kGreatestSize = 4000;
constexpr int kMargin = 30;
constexpr int kFooter = 110;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.6;

/// From metres in the map's frame to pixels of the canvas.
class View {
 public:
  explicit View(const grid::GridGeometry& geometry) : geometry_(geometry) {
    const int longest = std::max(geometry.width, geometry.height);
    // Whole factors keep cells square and edges sharp.
    scale_ = longest <= kGreatestSize ? (kLeastSize + longest - 1) / longest
                                      : static_cast<double>(kGreatestSize) / longest;
  }

  /// Pixels a cell.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double pixelsPerMetre() const { return scale_ / geometry_.resolution; }
  [[nodiscard]] int mapWidth() const { return pixels(geometry_.width); }
  [[nodiscard]] int mapHeight() const { return pixels(geometry_.height); }

  /// Column and row, in cells counted from the upper left corner, to a pixel.
  [[nodiscard]] int pixels(double cells) const {
    return std::max(1, static_cast<int>(std::lround(cells * scale_)));
  }

  /// Pixel with four binary places, as OpenCV's drawing with shift 4 wants it.
  [[nodiscard]] cv::Point place(const geometry::Pose2& pose) const {
    const Eigen::Vector2d p = (pose.translation() - geometry_.origin) * pixelsPerMetre();
    // A path may leave the map, but OpenCV's coordinates must not overflow.
    const auto coordinate = [](double value) {
      return static_cast<int>(std::lround(std::clamp(value, -1e6, 1e6) * (1 << kShift)));
    };
    return {coordinate(p.x()), coordinate(mapHeight() - p.y())};
  }

  static constexpr int kShift = 4;

 private:
  grid::GridGeometry geometry_;
  double scale_{1.0};
};

/// Grey level for sorting: what wins where cells share a pixel.
int rank(std::int8_t value) { return value < 0 ? 0 : (value < 50 ? 1 : 2); }

cv::Mat drawCells(const grid::OccupancyGrid& map, const View& view) {
  cv::Mat ranks(view.mapHeight(), view.mapWidth(), CV_8UC1, cv::Scalar(0));
  const auto first = [&view](int index) { return static_cast<int>(index * view.scale()); };
  for (int y = 0; y < map.geometry.height; ++y) {
    const int row = map.geometry.height - 1 - y;
    for (int x = 0; x < map.geometry.width; ++x) {
      const int value = rank(map.at({x, y}));
      if (value == 0) {
        continue;
      }
      const int bottom = std::min(std::max(first(row + 1), first(row) + 1), ranks.rows);
      const int right = std::min(std::max(first(x + 1), first(x) + 1), ranks.cols);
      for (int v = first(row); v < bottom; ++v) {
        for (int u = first(x); u < right; ++u) {
          auto& pixel = ranks.at<std::uint8_t>(v, u);
          pixel = std::max(pixel, static_cast<std::uint8_t>(value));
        }
      }
    }
  }
  cv::Mat colours(ranks.size(), CV_8UC3, kUnknownColour);
  colours.setTo(kFreeColour, ranks == 1);
  colours.setTo(kWallColour, ranks == 2);
  return colours;
}

int lineWidth(const cv::Mat& canvas) {
  return std::max(2, std::max(canvas.rows, canvas.cols) / 600);
}

void drawPath(const geometry::Trajectory& path, const View& view, const cv::Scalar& colour,
              cv::Mat& canvas) {
  std::vector<cv::Point> points;
  for (const geometry::StampedPose2& entry : path) {
    if (entry.pose.isFinite()) {
      points.push_back(view.place(entry.pose));
    }
  }
  cv::polylines(canvas, points, false, colour, lineWidth(canvas), cv::LINE_AA, View::kShift);
}

void drawMark(const geometry::Pose2& pose, const View& view, const cv::Scalar& colour,
              cv::Mat& canvas) {
  if (!pose.isFinite()) {
    return;
  }
  const int radius = (3 * lineWidth(canvas)) << View::kShift;
  const cv::Point centre = view.place(pose);
  cv::circle(canvas, centre, radius, colour, cv::FILLED, cv::LINE_AA, View::kShift);
  cv::circle(canvas, centre, radius, kFreeColour, lineWidth(canvas), cv::LINE_AA, View::kShift);
}

void write(cv::Mat& canvas, const std::string& text, const cv::Point& place) {
  cv::putText(canvas, text, place, kFont, kFontScale, kInkColour, 1, cv::LINE_AA);
}

int textWidth(const std::string& text) {
  int baseline = 0;
  return cv::getTextSize(text, kFont, kFontScale, 1, &baseline).width;
}

/// The largest of 1, 2, 5 times a power of ten [m] that is at most so long.
double roundLength(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= longest) {
      return factor * power;
    }
  }
  return power;
}

void drawScaleBar(const View& view, const cv::Point& place, cv::Mat& canvas) {
  constexpr double kLongest = 220.0;  // [pixels]
  const double length = roundLength(kLongest / view.pixelsPerMetre());
  const int pixels = static_cast<int>(std::lround(length * view.pixelsPerMetre()));
  const cv::Point end = place + cv::Point(pixels, 0);
  const cv::Point tick(0, 6);
  cv::line(canvas, place, end, kInkColour, 2);
  cv::line(canvas, place - tick, place + tick, kInkColour, 2);
  cv::line(canvas, end - tick, end + tick, kInkColour, 2);
  write(canvas, fmt::format("{:g} m", length), end + cv::Point(12, 6));
}

/// Draws `sample`, then `text` behind it. @return where the next entry goes
cv::Point drawEntry(const std::string& text, const cv::Scalar& colour, bool dot, cv::Point place,
                    cv::Mat& canvas) {
  const cv::Point middle = place + cv::Point(14, -6);
  if (dot) {
    cv::circle(canvas, middle, 7, colour, cv::FILLED, cv::LINE_AA);
  } else {
    cv::line(canvas, middle - cv::Point(14, 0), middle + cv::Point(14, 0), colour, 4, cv::LINE_AA);
  }
  write(canvas, text, place + cv::Point(38, 0));
  return place + cv::Point(38 + textWidth(text) + 30, 0);
}

void drawLegend(const MapPicture& picture, cv::Point place, cv::Mat& canvas) {
  if (!picture.estimated_path.empty()) {
    place = drawEntry("estimated path", kEstimateColour, false, place, canvas);
    place = drawEntry("start", kStartColour, true, place, canvas);
    place = drawEntry("end", kEstimateColour, true, place, canvas);
  }
  if (!picture.true_path.empty()) {
    drawEntry("true path", kTruthColour, false, place, canvas);
  }
}

void drawPaths(const MapPicture& picture, const View& view, cv::Mat& canvas) {
  drawPath(picture.true_path, view, kTruthColour, canvas);
  drawPath(picture.estimated_path, view, kEstimateColour, canvas);
  if (!picture.estimated_path.empty()) {
    drawMark(picture.estimated_path.front().pose, view, kStartColour, canvas);
    drawMark(picture.estimated_path.back().pose, view, kEstimateColour, canvas);
  }
}

cv::Mat draw(const MapPicture& picture) {
  const View view(picture.map.geometry);
  // Narrow maps still need room for what stands below them.
  constexpr int kLeastWidth = 760;
  const int width = std::max({view.mapWidth(), textWidth(picture.caption), kLeastWidth});
  cv::Mat canvas(view.mapHeight() + 2 * kMargin + kFooter, width + 2 * kMargin, CV_8UC3,
                 kUnknownColour);
  const int left = kMargin + (width - view.mapWidth()) / 2;
  cv::Mat area = canvas(cv::Rect(left, kMargin, view.mapWidth(), view.mapHeight()));
  drawCells(picture.map, view).copyTo(area);
  drawPaths(picture, view, area);
  cv::Mat footer = canvas.rowRange(canvas.rows - kFooter, canvas.rows);
  footer.setTo(kFreeColour);
  drawScaleBar(view, {kMargin, 30}, footer);
  drawLegend(picture, {kMargin, 64}, footer);
  write(footer, picture.caption, {kMargin, 96});
  return canvas;
}

}  // namespace

std::string encodeMapPicture(const MapPicture& picture) {
  const grid::GridGeometry& geometry = picture.map.geometry;
  if (geometry.width <= 0 || geometry.height <= 0 || picture.map.cells.size() != geometry.size() ||
      !(geometry.resolution > 0.0)) {
    throw std::invalid_argument("a map without cells has no picture");
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", draw(picture), bytes);
  return {bytes.begin(), bytes.end()};
}

std::string writeMapPicture(const std::filesystem::path& path, const MapPicture& picture) {
  try {
    return grid::writeFileAtomically(path, encodeMapPicture(picture));
  } catch (const std::exception& error) {  // OpenCV's among them
    return fmt::format("{} could not be written: {}.", path.string(), error.what());
  }
}

}  // namespace omega_slam::evaluation
