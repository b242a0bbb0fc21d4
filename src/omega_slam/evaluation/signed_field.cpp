#include "omega_slam/evaluation/signed_field.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "omega_slam/evaluation/cell_mask.h"

namespace omega_slam::evaluation {
namespace {

using grid::Cell;
using grid::OccupancyGrid;

struct Counts {
  std::size_t walls{0};
  std::size_t open{0};
};

Counts countKnown(const OccupancyGrid& map) {
  Counts counts;
  for (const std::int8_t value : map.cells) {
    counts.walls += isWall(value) ? 1U : 0U;
    counts.open += isOpen(value) ? 1U : 0U;
  }
  return counts;
}

}  // namespace

std::vector<SignedPoint> signedPoints(const OccupancyGrid& map, std::size_t most_open) {
  const Counts counts = countKnown(map);
  const std::size_t stride = counts.open / std::max<std::size_t>(most_open, 1) + 1;
  const std::size_t kept = (counts.open + stride - 1) / stride;
  std::vector<SignedPoint> points;
  std::size_t open = 0;
  forEachCell(map.geometry, [&](const Cell& cell) {
    if (isWall(map.at(cell))) {
      points.push_back({map.geometry.center(cell), 1.0 / static_cast<double>(counts.walls)});
    } else if (isOpen(map.at(cell)) && open++ % stride == 0) {
      points.push_back({map.geometry.center(cell), -1.0 / static_cast<double>(kept)});
    }
  });
  return points;
}

SignedField::SignedField(const OccupancyGrid& map, double deviation)
    : geometry_(map.geometry), values_(map.geometry.height, map.geometry.width, CV_32FC1) {
  const Counts counts = countKnown(map);
  const double open =
      counts.open == 0
          ? 0.0
          : -std::min(1.0, static_cast<double>(counts.walls) / static_cast<double>(counts.open));
  forEachCell(map.geometry, [&](const Cell& cell) {
    const std::int8_t value = map.at(cell);
    values_.at<float>(cell.y(), cell.x()) =
        static_cast<float>(isWall(value) ? 1.0 : (isOpen(value) ? open : 0.0));
  });
  cv::GaussianBlur(values_, values_, {}, deviation, deviation, cv::BORDER_CONSTANT);
}

double SignedField::at(const Eigen::Vector2d& point) const {
  const Eigen::Array2d place =
      (point - geometry_.origin).array() / geometry_.resolution - Eigen::Array2d(0.5, 0.5);
  if (!(place >= 0.0).all() || place.x() >= geometry_.width - 1 ||
      place.y() >= geometry_.height - 1) {
    return 0.0;
  }
  const Cell low = place.floor().cast<int>();
  const Eigen::Array2d share = place - low.cast<double>().array();
  const auto* lower = values_.ptr<float>(low.y()) + low.x();
  const auto* upper = values_.ptr<float>(low.y() + 1) + low.x();
  const double below = (1.0 - share.x()) * lower[0] + share.x() * lower[1];
  const double above = (1.0 - share.x()) * upper[0] + share.x() * upper[1];
  return (1.0 - share.y()) * below + share.y() * above;
}

}  // namespace omega_slam::evaluation
