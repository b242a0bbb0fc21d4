#include "omega_slam/evaluation/map_correlation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/evaluation/signed_field.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"

namespace omega_slam::evaluation {
namespace {

using geometry::Pose2;
using grid::OccupancyGrid;
using Points = std::vector<SignedPoint>;

constexpr std::size_t kFewOpen = 4000;    // open cells that stand for all in a search
constexpr std::size_t kManyOpen = 20000;  // and in the last one
constexpr double kCoarseCells = 4.0;      // cells of the true map along a coarse one
constexpr double kMostCoarse = 128.0;     // coarse cells along the longer map
constexpr double kFineDeviation = 1.5;    // [cells] of the last field's blur
constexpr double kLastStep = 0.02;        // [cells] of the last field
constexpr int kMaxMoves = 1000;           // of a compass search

bool hasWalls(const OccupancyGrid& map) {
  return std::any_of(map.cells.begin(), map.cells.end(), isWall);
}

double extentOf(const OccupancyGrid& map) {
  return map.geometry.resolution * std::max(map.geometry.width, map.geometry.height);
}

/// Points about their middle, so that turning them does not move them.
struct CentredPoints {
  Eigen::Vector2d middle{0.0, 0.0};  ///< in the frame of the map
  Points points;                     ///< seen from there
  double radius{0.0};                ///< [m] of the farthest

  explicit CentredPoints(Points all) : points(std::move(all)) {
    Eigen::AlignedBox2d box;
    for (const SignedPoint& point : points) {
      box.extend(point.point);
    }
    middle = box.center();
    for (SignedPoint& point : points) {
      point.point -= middle;
      radius = std::max(radius, point.point.norm());
    }
  }

  /// The pose of the map whose middle lies at a pose.
  [[nodiscard]] Pose2 poseOfMap(const Pose2& T_truth_middle) const {
    return T_truth_middle * Pose2{-middle.x(), -middle.y(), 0.0};
  }
  [[nodiscard]] Pose2 poseOfMiddle(const Pose2& T_truth_map) const {
    return T_truth_map * Pose2{middle.x(), middle.y(), 0.0};
  }
};

/// Sums of points in coarse cells; the transforms of two of them make a correlation.
class CoarseGrid {
 public:
  CoarseGrid(double cell, double extent) : cell_(cell) {
    size_ = cv::getOptimalDFTSize(static_cast<int>(std::ceil(extent / cell)) + 2);
  }

  /// @param heading by which the points are turned about their middle, which lies in the middle
  [[nodiscard]] cv::Mat transformOf(const Points& points, double heading) const {
    cv::Mat sums(size_, size_, CV_32FC1, cv::Scalar(0.0));
    const Pose2 turn{0.0, 0.0, heading};
    for (const SignedPoint& point : points) {
      const Eigen::Array2d place = (turn * point.point).array() / cell_ + 0.5 * size_;
      sums.at<float>(static_cast<int>(place.y()), static_cast<int>(place.x())) +=
          static_cast<float>(point.value);
    }
    cv::GaussianBlur(sums, sums, {}, 1.0, 1.0, cv::BORDER_CONSTANT);
    cv::dft(sums, sums);
    return sums;
  }

  /// Where the middle of the one lies, seen from that of the other, where they correlate most.
  [[nodiscard]] MapCorrelation best(const cv::Mat& truth, const cv::Mat& built,
                                    double heading) const {
    cv::Mat correlation;
    cv::mulSpectrums(truth, built, correlation, 0, true);
    cv::dft(correlation, correlation, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    double value = 0.0;
    cv::Point place;
    cv::minMaxLoc(correlation, nullptr, &value, nullptr, &place);
    // The second half of the shifts are those below zero.
    const auto shift = [this](int index) {
      return cell_ * (index > size_ / 2 ? index - size_ : index);
    };
    return {{shift(place.x), shift(place.y), heading}, value};
  }

 private:
  double cell_;
  int size_;
};

/// Middles of the built map in the true map's frame, the best first.
std::vector<MapCorrelation> searchCoarsely(const CentredPoints& built, const CentredPoints& truth,
                                           double cell, const MapCorrelationOptions& options) {
  const CoarseGrid grid(cell, 2.0 * (built.radius + truth.radius));
  const cv::Mat transform = grid.transformOf(truth.points, 0.0);
  std::vector<MapCorrelation> found;
  for (int k = 0; k < options.headings; ++k) {
    const double heading = geometry::normalizeAngle(2.0 * geometry::kPi * k / options.headings);
    MapCorrelation best = grid.best(transform, grid.transformOf(built.points, heading), heading);
    best.T_truth_map.x += truth.middle.x();
    best.T_truth_map.y += truth.middle.y();
    found.push_back(best);
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const MapCorrelation& a, const MapCorrelation& b) { return a.value > b.value; });
  found.resize(std::min(found.size(), static_cast<std::size_t>(options.candidates)));
  return found;
}

double correlate(const Points& points, const SignedField& field, const Pose2& T_truth_middle) {
  double sum = 0.0;
  const Eigen::Isometry2d motion =
      Eigen::Translation2d(T_truth_middle.translation()) * Eigen::Rotation2Dd(T_truth_middle.theta);
  for (const SignedPoint& point : points) {
    sum += point.value * field.at(motion * point.point);
  }
  return sum;
}

/// Six neighbours are tried; where none is better, the step is halved.
/// @param first, last [m] steps; a turn moves the farthest point by as much
MapCorrelation climb(const CentredPoints& built, const SignedField& field, Pose2 pose, double first,
                     double last) {
  MapCorrelation best{pose, correlate(built.points, field, pose)};
  double step = first;
  for (int moves = 0; step >= last && moves < kMaxMoves; ++moves) {
    const double turn = step / std::max(built.radius, step);
    const std::array<Eigen::Vector3d, 3> axes{Eigen::Vector3d(step, 0.0, 0.0),
                                              Eigen::Vector3d(0.0, step, 0.0),
                                              Eigen::Vector3d(0.0, 0.0, turn)};
    const MapCorrelation from = best;
    for (const Eigen::Vector3d& axis : axes) {
      for (const double sign : {1.0, -1.0}) {
        const Eigen::Vector3d moved = from.T_truth_map.vector() + sign * axis;
        const Pose2 candidate{moved.x(), moved.y(), geometry::normalizeAngle(moved.z())};
        const double value = correlate(built.points, field, candidate);
        if (value > best.value) {
          best = {candidate, value};
        }
      }
    }
    step = best.value > from.value ? step : 0.5 * step;
  }
  return best;
}

double coarseCell(const OccupancyGrid& built, const OccupancyGrid& truth) {
  return std::max(kCoarseCells * truth.geometry.resolution,
                  std::max(extentOf(built), extentOf(truth)) / kMostCoarse);
}

/// The last, fine search. @param guess right within a few cells
MapCorrelation finish(const OccupancyGrid& built, const OccupancyGrid& truth, const Pose2& guess) {
  const double cell = truth.geometry.resolution;
  const CentredPoints points(signedPoints(built, kManyOpen));
  MapCorrelation best = climb(points, SignedField(truth, kFineDeviation),
                              points.poseOfMiddle(guess), 2.0 * cell, kLastStep * cell);
  best.T_truth_map = points.poseOfMap(best.T_truth_map);
  return best;
}

/// The best of the guesses after a search in a blurred field.
Pose2 refine(const OccupancyGrid& built, const OccupancyGrid& truth,
             const std::vector<Pose2>& guesses) {
  const double coarse = coarseCell(built, truth);
  const CentredPoints points(signedPoints(built, kFewOpen));
  const SignedField field(truth, coarse / truth.geometry.resolution);
  std::optional<MapCorrelation> best;
  for (const Pose2& guess : guesses) {
    const MapCorrelation found =
        climb(points, field, points.poseOfMiddle(guess), coarse, 0.125 * coarse);
    if (!best || found.value > best->value) {
      best = found;
    }
  }
  return points.poseOfMap(best.value().T_truth_map);
}

}  // namespace

std::vector<std::string> MapCorrelationOptions::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("headings", headings, 1.0);
  violations.requireAtLeast("candidates", candidates, 1.0);
  return violations.sentences();
}

std::optional<MapCorrelation> alignByCorrelation(const OccupancyGrid& built,
                                                 const OccupancyGrid& truth,
                                                 const MapCorrelationOptions& options) {
  geometry::throwIfAny(options.validate());
  if (!hasWalls(built) || !hasWalls(truth)) {
    return std::nullopt;
  }
  const CentredPoints points(signedPoints(built, kManyOpen));
  const std::vector<MapCorrelation> coarse = searchCoarsely(
      points, CentredPoints(signedPoints(truth, kManyOpen)), coarseCell(built, truth), options);
  std::vector<Pose2> guesses;
  for (const MapCorrelation& candidate : coarse) {
    guesses.push_back(points.poseOfMap(candidate.T_truth_map));
  }
  return finish(built, truth, refine(built, truth, guesses));
}

}  // namespace omega_slam::evaluation
