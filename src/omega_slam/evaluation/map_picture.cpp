#include "omega_slam/evaluation/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "omega_slam/evaluation/map_canvas.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::evaluation {
namespace {

const cv::Scalar kEstimateColour(40, 96, 226);
const cv::Scalar kTruthColour(178, 134, 44);
const cv::Scalar kStartColour(84, 150, 38);

/// What wins where cells share a pixel.
std::uint8_t rank(std::int8_t value) {
  return static_cast<std::uint8_t>(value < 0 ? 0 : (value < 50 ? 1 : 2));
}

int lineWidth(const cv::Mat& canvas) {
  return std::max(2, std::max(canvas.rows, canvas.cols) / 600);
}

void drawPath(const geometry::Trajectory& path, const MapView& view, const cv::Scalar& colour,
              cv::Mat& canvas) {
  std::vector<cv::Point> points;
  for (const geometry::StampedPose2& entry : path) {
    if (entry.pose.isFinite()) {
      points.push_back(view.place(entry.pose));
    }
  }
  cv::polylines(canvas, points, false, colour, lineWidth(canvas), cv::LINE_AA, MapView::kShift);
}

void drawMark(const geometry::Pose2& pose, const MapView& view, const cv::Scalar& colour,
              cv::Mat& canvas) {
  if (!pose.isFinite()) {
    return;
  }
  const int radius = (3 * lineWidth(canvas)) << MapView::kShift;
  const cv::Point centre = view.place(pose);
  cv::circle(canvas, centre, radius, colour, cv::FILLED, cv::LINE_AA, MapView::kShift);
  cv::circle(canvas, centre, radius, kFreeColour, lineWidth(canvas), cv::LINE_AA, MapView::kShift);
}

std::vector<LegendEntry> legendOf(const MapPicture& picture) {
  std::vector<LegendEntry> legend;
  if (!picture.estimated_path.empty()) {
    legend.push_back({"estimated path", kEstimateColour, false});
    legend.push_back({"start", kStartColour, true});
    legend.push_back({"end", kEstimateColour, true});
  }
  if (!picture.true_path.empty()) {
    legend.push_back({"true path", kTruthColour, false});
  }
  return legend;
}

void drawPaths(const MapPicture& picture, const MapView& view, cv::Mat& canvas) {
  drawPath(picture.true_path, view, kTruthColour, canvas);
  drawPath(picture.estimated_path, view, kEstimateColour, canvas);
  if (!picture.estimated_path.empty()) {
    drawMark(picture.estimated_path.front().pose, view, kStartColour, canvas);
    drawMark(picture.estimated_path.back().pose, view, kEstimateColour, canvas);
  }
}

}  // namespace

std::string encodeMapPicture(const MapPicture& picture) {
  requireCells(picture.map.geometry, picture.map.cells.size());
  const MapView view(picture.map.geometry);
  cv::Mat canvas =
      paintCells(picture.map.geometry, view,
                 [&picture](const grid::Cell& cell) { return rank(picture.map.at(cell)); },
                 {kUnknownColour, kFreeColour, kWallColour});
  drawPaths(picture, view, canvas);
  return encodePng(frameMap(canvas, view, legendOf(picture), picture.caption));
}

std::string writeMapPicture(const std::filesystem::path& path, const MapPicture& picture) {
  try {
    return grid::writeFileAtomically(path, encodeMapPicture(picture));
  } catch (const std::exception& error) {  // OpenCV's among them
    return fmt::format("{} could not be written: {}.", path.string(), error.what());
  }
}

}  // namespace omega_slam::evaluation
