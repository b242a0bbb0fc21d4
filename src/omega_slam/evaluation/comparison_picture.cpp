#include "omega_slam/evaluation/comparison_picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/evaluation/map_canvas.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::evaluation {
namespace {

using grid::Cell;
using grid::GridGeometry;

constexpr double kMostCells = 1 << 26;

const cv::Scalar kWrongWall(38, 38, 214);
const cv::Scalar kMissedWall(196, 110, 20);
const cv::Scalar kWrongOpen(60, 160, 245);
const cv::Scalar kUnseenOpen(245, 222, 190);

/// Colours by rank, and what they are called.
const std::vector<cv::Scalar> kColours{kUnknownColour, kFreeColour, kUnseenOpen, kWrongOpen,
                                       kWallColour,    kMissedWall, kWrongWall};

/// By verdict: its place among the colours, the graver the higher.
std::uint8_t rank(Verdict verdict) {
  constexpr std::array<std::uint8_t, 8> kRanks{0, 4, 6, 5, 1, 3, 2, 2};
  return kRanks.at(static_cast<std::size_t>(verdict));
}

/// The true map's cells, as many more as the built map needs.
GridGeometry canvasFor(const GridGeometry& built, const GridGeometry& truth,
                       const geometry::Pose2& T_truth_map) {
  Eigen::AlignedBox2d box(
      truth.origin, truth.origin + truth.resolution * Eigen::Vector2d(truth.width, truth.height));
  for (const Cell& corner :
       {Cell(0, 0), Cell(built.width, 0), Cell(0, built.height), Cell(built.width, built.height)}) {
    box.extend(T_truth_map * (built.origin + built.resolution * corner.cast<double>()));
  }
  const auto wholeCells = [&truth](const Eigen::Vector2d& length) -> Eigen::Array2d {
    constexpr double kRounding = 1e-6;  // [cells] that make no cell of their own
    return (length.array() / truth.resolution - kRounding).ceil().max(0.0);
  };
  const Eigen::Array2d below = wholeCells(truth.origin - box.min());
  const Eigen::Array2d size = below + wholeCells(box.max() - truth.origin);
  if (!(size.prod() <= kMostCells)) {
    throw std::invalid_argument("the maps lie too far apart for a picture of both");
  }
  GridGeometry canvas = truth;
  canvas.origin = truth.origin - truth.resolution * below.matrix();
  canvas.width = static_cast<int>(size.x());
  canvas.height = static_cast<int>(size.y());
  return canvas;
}

/// The verdict on the cell of a map that holds a point; kNone outside.
Verdict verdictAt(const GridGeometry& geometry, const std::vector<Verdict>& verdicts,
                  const Eigen::Vector2d& point) {
  const Cell cell = geometry.cellAt(point);
  return geometry.contains(cell) ? verdicts[geometry.index(cell)] : Verdict::kNone;
}

/// Verdicts on built cells, and beneath them those on what was missed.
std::vector<std::uint8_t> ranksOf(const ComparisonPicture& picture, const GridGeometry& canvas) {
  std::vector<std::uint8_t> ranks(canvas.size(), 0);
  const geometry::Pose2 T_map_truth = picture.T_truth_map.inverse();
  forEachCell(canvas, [&](const Cell& cell) {
    const Eigen::Vector2d p_truth = canvas.center(cell);
    const Verdict built =
        verdictAt(picture.built.geometry, picture.comparison.built, T_map_truth * p_truth);
    const Verdict truth = verdictAt(picture.truth.geometry, picture.comparison.truth, p_truth);
    const bool is_missed = truth == Verdict::kWallMissed || truth == Verdict::kOpenUnseen;
    const bool is_wall = built == Verdict::kWallRight || built == Verdict::kWallWrong;
    ranks[canvas.index(cell)] =
        is_missed && !is_wall ? std::max(rank(truth), rank(built)) : rank(built);
  });
  return ranks;
}

}  // namespace

std::string encodeComparisonPicture(const ComparisonPicture& picture) {
  requireCells(picture.built.geometry, picture.comparison.built.size());
  requireCells(picture.truth.geometry, picture.comparison.truth.size());
  const GridGeometry canvas =
      canvasFor(picture.built.geometry, picture.truth.geometry, picture.T_truth_map);
  const std::vector<std::uint8_t> ranks = ranksOf(picture, canvas);
  const MapView view(canvas);
  const cv::Mat painted = paintCells(
      canvas, view, [&](const Cell& cell) { return ranks[canvas.index(cell)]; }, kColours);
  return encodePng(frameMap(painted, view,
                            {{"wall right", kWallColour, true},
                             {"wall wrong", kWrongWall, true},
                             {"wall missed", kMissedWall, true},
                             {"open wrong", kWrongOpen, true},
                             {"open not seen", kUnseenOpen, true}},
                            picture.caption));
}

std::string writeComparisonPicture(const std::filesystem::path& path,
                                   const ComparisonPicture& picture) {
  try {
    return grid::writeFileAtomically(path, encodeComparisonPicture(picture));
  } catch (const std::exception& error) {  // OpenCV's among them
    return fmt::format("{} could not be written: {}.", path.string(), error.what());
  }
}

}  // namespace omega_slam::evaluation
