#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::evaluation {

/// What pictures of maps have in common. Colours are blue, green, red, as OpenCV has them.
inline const cv::Scalar kUnknownColour(214, 211, 208);
inline const cv::Scalar kFreeColour(255, 255, 255);
inline const cv::Scalar kWallColour(58, 46, 40);

/// From metres in the map's frame to pixels of a picture: small maps are magnified by a whole
/// number to 1000 pixels or more, large ones reduced to 4000.
class MapView {
 public:
  explicit MapView(const grid::GridGeometry& geometry);

  /// Pixels a cell.
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double pixelsPerMetre() const { return scale_ / geometry_.resolution; }
  [[nodiscard]] int mapWidth() const { return pixels(geometry_.width); }
  [[nodiscard]] int mapHeight() const { return pixels(geometry_.height); }

  /// Pixel with four binary places, as OpenCV's drawing with shift 4 wants it.
  [[nodiscard]] cv::Point place(const geometry::Pose2& pose) const;

  static constexpr int kShift = 4;

 private:
  [[nodiscard]] int pixels(double cells) const;

  grid::GridGeometry geometry_;
  double scale_{1.0};
};

/// Paints each cell in `colours[rank(cell)]`. Where many cells share a pixel the highest rank wins.
[[nodiscard]] cv::Mat paintCells(const grid::GridGeometry& geometry, const MapView& view,
                                 const std::function<std::uint8_t(const grid::Cell&)>& rank,
                                 const std::vector<cv::Scalar>& colours);

/// One entry of a legend.
struct LegendEntry {
  std::string text;
  cv::Scalar colour;
  bool is_dot{false};  ///< else a line
};

/// Frames a painted map, with a scale bar, a legend and a caption below it.
[[nodiscard]] cv::Mat frameMap(const cv::Mat& map, const MapView& view,
                               const std::vector<LegendEntry>& legend, const std::string& caption);

/// @param picture of colours
/// @return the bytes of a PNG; the same picture gives the same bytes
[[nodiscard]] std::string encodePng(const cv::Mat& picture);

/// @throws std::invalid_argument for a map without cells, of which there is no picture
void requireCells(const grid::GridGeometry& geometry, std::size_t cells);

}  // namespace omega_slam::evaluation
