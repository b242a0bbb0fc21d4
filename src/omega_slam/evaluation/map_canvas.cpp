#include "omega_slam/evaluation/map_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/grid/png.h"

namespace omega_slam::evaluation {
namespace {

const cv::Scalar kInkColour(70, 62, 56);

constexpr int kLeastSize = 1000;
constexpr int kGreatestSize = 4000;
constexpr int kMargin = 30;
constexpr int kFooter = 110;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.6;

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

void drawScaleBar(const MapView& view, const cv::Point& place, cv::Mat& canvas) {
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

/// Draws a sample of the colour, then the text behind it. @return where the next entry goes
cv::Point drawEntry(const LegendEntry& entry, const cv::Point& place, cv::Mat& canvas) {
  const cv::Point middle = place + cv::Point(14, -6);
  if (entry.is_dot) {
    cv::circle(canvas, middle, 7, entry.colour, cv::FILLED, cv::LINE_AA);
  } else {
    cv::line(canvas, middle - cv::Point(14, 0), middle + cv::Point(14, 0), entry.colour, 4,
             cv::LINE_AA);
  }
  write(canvas, entry.text, place + cv::Point(38, 0));
  return place + cv::Point(38 + textWidth(entry.text) + 30, 0);
}

int legendWidth(const std::vector<LegendEntry>& legend) {
  int width = 0;
  for (const LegendEntry& entry : legend) {
    width += 38 + textWidth(entry.text) + 30;
  }
  return width;
}

}  // namespace

MapView::MapView(const grid::GridGeometry& geometry) : geometry_(geometry) {
  const int longest = std::max(geometry.width, geometry.height);
  // Whole factors keep cells square and edges sharp.
  scale_ = longest <= kGreatestSize ? (kLeastSize + longest - 1) / longest
                                    : static_cast<double>(kGreatestSize) / longest;
}

int MapView::pixels(double cells) const {
  return std::max(1, static_cast<int>(std::lround(cells * scale_)));
}

cv::Point MapView::place(const geometry::Pose2& pose) const {
  const Eigen::Vector2d p = (pose.translation() - geometry_.origin) * pixelsPerMetre();
  // A path may leave the map, but OpenCV's coordinates must not overflow.
  const auto coordinate = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e6, 1e6) * (1 << kShift)));
  };
  return {coordinate(p.x()), coordinate(mapHeight() - p.y())};
}

cv::Mat paintCells(const grid::GridGeometry& geometry, const MapView& view,
                   const std::function<std::uint8_t(const grid::Cell&)>& rank,
                   const std::vector<cv::Scalar>& colours) {
  cv::Mat ranks(view.mapHeight(), view.mapWidth(), CV_8UC1, cv::Scalar(0));
  const auto first = [&view](int index) { return static_cast<int>(index * view.scale()); };
  forEachCell(geometry, [&](const grid::Cell& cell) {
    const int row = geometry.height - 1 - cell.y();
    const int bottom = std::min(std::max(first(row + 1), first(row) + 1), ranks.rows);
    const int right = std::min(std::max(first(cell.x() + 1), first(cell.x()) + 1), ranks.cols);
    const std::uint8_t value = rank(cell);
    for (int v = first(row); v < bottom; ++v) {
      for (int u = first(cell.x()); u < right; ++u) {
        auto& pixel = ranks.at<std::uint8_t>(v, u);
        pixel = std::max(pixel, value);
      }
    }
  });
  cv::Mat picture(ranks.size(), CV_8UC3, colours.front());
  for (std::size_t value = 1; value < colours.size(); ++value) {
    picture.setTo(colours[value], ranks == static_cast<double>(value));
  }
  return picture;
}

cv::Mat frameMap(const cv::Mat& map, const MapView& view, const std::vector<LegendEntry>& legend,
                 const std::string& caption) {
  // Narrow maps still need room for what stands below them.
  constexpr int kLeastWidth = 760;
  const int width = std::max({map.cols, textWidth(caption), legendWidth(legend), kLeastWidth});
  cv::Mat canvas(map.rows + 2 * kMargin + kFooter, width + 2 * kMargin, CV_8UC3, kUnknownColour);
  const int left = kMargin + (width - map.cols) / 2;
  map.copyTo(canvas(cv::Rect(left, kMargin, map.cols, map.rows)));
  cv::Mat footer = canvas.rowRange(canvas.rows - kFooter, canvas.rows);
  footer.setTo(kFreeColour);
  drawScaleBar(view, {kMargin, 30}, footer);
  cv::Point place(kMargin, 64);
  for (const LegendEntry& entry : legend) {
    place = drawEntry(entry, place, footer);
  }
  write(footer, caption, {kMargin, 96});
  return canvas;
}

std::string encodePng(const cv::Mat& picture) {
  return grid::encodePng({picture.cols, picture.rows, grid::PixelFormat::kBlueGreenRed,
                          picture.data, picture.step[0]});
}

void requireCells(const grid::GridGeometry& geometry, std::size_t cells) {
  if (geometry.width <= 0 || geometry.height <= 0 || cells != geometry.size() ||
      !(geometry.resolution > 0.0)) {
    throw std::invalid_argument("a map without cells has no picture");
  }
}

}  // namespace omega_slam::evaluation
