#include "omega_slam/evaluation/feature_alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <vector>

#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/evaluation/rigid_fit.h"

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 4)
#define OMEGA_SLAM_HAS_SIFT
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#endif

namespace omega_slam::evaluation {

#ifdef OMEGA_SLAM_HAS_SIFT

namespace {

constexpr double kDistinctive = 0.8;       // a match is this much nearer than the next best (Lowe)
constexpr double kReprojection = 3.0;      // [pixels] a pair agrees within so many
constexpr double kScaleDeviation = 0.05;   // maps have a scale
constexpr std::size_t kLeastInliers = 8;   // fewer agree by chance
constexpr std::size_t kIterations = 5000;  // of RANSAC
constexpr int kUnknownGrey = 205;
constexpr double kRefitReach = 1.5;  // [pixels]
constexpr int kRefits = 5;
constexpr int kMargin = 16;  // [pixels] SIFT sees nothing near the edge

/// Points in metres, in the frame of their map; `pixels` as SIFT has them.
struct ControlPoints {
  std::vector<cv::Point2f> pixels;
  std::vector<Eigen::Vector2d> places;
  cv::Mat descriptors;
};

/// As map_server's files look, but row 0 on top: both maps alike, so it does not matter. The inside
/// of walls is unknown: no laser sees it.
cv::Mat imageOf(const grid::OccupancyGrid& map, double pixel) {
  cv::Mat image(map.geometry.height, map.geometry.width, CV_8UC1, cv::Scalar(kUnknownGrey));
  const CellMask open = openCells(map);
  forEachCell(map.geometry, [&](const grid::Cell& cell) {
    auto& grey = image.at<std::uint8_t>(cell.y(), cell.x());
    if (open.at(cell)) {
      grey = 254;
    } else if (isWall(map.at(cell)) && open.touches(cell)) {
      grey = 0;
    }
  });
  const double factor = map.geometry.resolution / pixel;
  if (std::abs(factor - 1.0) > 1e-6) {
    cv::resize(image, image, {}, factor, factor, cv::INTER_AREA);
  }
  cv::copyMakeBorder(image, image, kMargin, kMargin, kMargin, kMargin, cv::BORDER_CONSTANT,
                     kUnknownGrey);
  return image;
}

ControlPoints findControlPoints(const grid::OccupancyGrid& map, double pixel) {
  std::vector<cv::KeyPoint> keypoints;
  ControlPoints points;
  cv::SIFT::create()->detectAndCompute(imageOf(map, pixel), cv::noArray(), keypoints,
                                       points.descriptors);
  for (const cv::KeyPoint& keypoint : keypoints) {
    points.pixels.push_back(keypoint.pt);
    // The middle of a pixel is where OpenCV counts from.
    const Eigen::Vector2d place(keypoint.pt.x - kMargin + 0.5, keypoint.pt.y - kMargin + 0.5);
    points.places.emplace_back(map.geometry.origin + pixel * place);
  }
  return points;
}

/// Pairs (built, truth) of points that look more alike than any other pair.
std::vector<cv::DMatch> matchPoints(const ControlPoints& built, const ControlPoints& truth) {
  std::vector<std::vector<cv::DMatch>> candidates;
  cv::BFMatcher(cv::NORM_L2).knnMatch(built.descriptors, truth.descriptors, candidates, 2);
  std::vector<cv::DMatch> matches;
  for (const auto& best : candidates) {
    if (best.size() == 2 && best[0].distance < kDistinctive * best[1].distance) {
      matches.push_back(best[0]);
    }
  }
  return matches;
}

/// Those on whose displacement most agree; none if they agree on another scale.
std::vector<cv::DMatch> chooseByRansac(const ControlPoints& built, const ControlPoints& truth,
                                       const std::vector<cv::DMatch>& matches) {
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (const cv::DMatch& match : matches) {
    from.push_back(built.pixels[static_cast<std::size_t>(match.queryIdx)]);
    to.push_back(truth.pixels[static_cast<std::size_t>(match.trainIdx)]);
  }
  std::vector<std::uint8_t> chosen;
  const cv::Mat similarity =
      cv::estimateAffinePartial2D(from, to, chosen, cv::RANSAC, kReprojection, kIterations, 0.999);
  std::vector<cv::DMatch> inliers;
  if (similarity.empty()) {
    return inliers;
  }
  const double scale = std::hypot(similarity.at<double>(0, 0), similarity.at<double>(1, 0));
  for (std::size_t k = 0; k < matches.size() && std::abs(scale - 1.0) < kScaleDeviation; ++k) {
    if (chosen[k] != 0) {
      inliers.push_back(matches[k]);
    }
  }
  return inliers;
}

std::vector<PointPair> pairsOf(const ControlPoints& built, const ControlPoints& truth,
                               const std::vector<cv::DMatch>& matches) {
  std::vector<PointPair> pairs;
  for (const cv::DMatch& match : matches) {
    pairs.push_back({built.places[static_cast<std::size_t>(match.queryIdx)],
                     truth.places[static_cast<std::size_t>(match.trainIdx)]});
  }
  return pairs;
}

/// All control points of both maps that lie together once the maps lie on each other, each with the
/// nearest: those that look like others, too, may now have their say.
std::vector<PointPair> pairsNearby(const ControlPoints& built, const ControlPoints& truth,
                                   const geometry::Pose2& T_truth_map, double reach) {
  std::vector<PointPair> pairs;
  for (const Eigen::Vector2d& p_map : built.places) {
    const Eigen::Vector2d p_truth = T_truth_map * p_map;
    const auto nearest =
        std::min_element(truth.places.begin(), truth.places.end(),
                         [&p_truth](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                           return (a - p_truth).squaredNorm() < (b - p_truth).squaredNorm();
                         });
    if ((*nearest - p_truth).norm() < reach) {
      pairs.push_back({p_map, *nearest});
    }
  }
  return pairs;
}

/// Fits to the chosen pairs, then to all that agree.
geometry::Pose2 fit(const ControlPoints& built, const ControlPoints& truth,
                    const std::vector<cv::DMatch>& inliers, double reach) {
  geometry::Pose2 T_truth_map = fitRigidMotion(pairsOf(built, truth, inliers));
  for (int k = 0; k < kRefits; ++k) {
    const std::vector<PointPair> pairs = pairsNearby(built, truth, T_truth_map, reach);
    if (pairs.size() < inliers.size()) {
      break;
    }
    T_truth_map = fitRigidMotion(pairs);
  }
  return T_truth_map;
}

}  // namespace

bool hasControlPoints() { return true; }

FeatureAlignment alignByFeatures(const grid::OccupancyGrid& built,
                                 const grid::OccupancyGrid& truth) {
  FeatureAlignment result;
  if (built.cells.empty() || truth.cells.empty()) {
    result.reason = "A map without cells has no control points.";
    return result;
  }
  const double pixel = truth.geometry.resolution;
  const ControlPoints built_points = findControlPoints(built, pixel);
  const ControlPoints truth_points = findControlPoints(truth, pixel);
  result.built_points = built_points.pixels.size();
  result.truth_points = truth_points.pixels.size();
  std::vector<cv::DMatch> inliers;
  if (result.built_points >= 2 && result.truth_points >= 2) {
    const std::vector<cv::DMatch> matches = matchPoints(built_points, truth_points);
    result.matches = matches.size();
    if (result.matches >= kLeastInliers) {
      inliers = chooseByRansac(built_points, truth_points, matches);
    }
  }
  result.inliers = inliers.size();
  if (result.inliers < kLeastInliers) {
    result.reason = fmt::format(
        "Too few control points agree: {} and {} points, {} pairs, {} of which agree; {} must.",
        result.built_points, result.truth_points, result.matches, result.inliers, kLeastInliers);
    return result;
  }
  result.T_truth_map = fit(built_points, truth_points, inliers, kRefitReach * pixel);
  return result;
}

#else

bool hasControlPoints() { return false; }

FeatureAlignment alignByFeatures(const grid::OccupancyGrid&, const grid::OccupancyGrid&) {
  FeatureAlignment result;
  result.reason = fmt::format("SIFT is not in this OpenCV ({}), but in 4.4 and later.", CV_VERSION);
  return result;
}

#endif

}  // namespace omega_slam::evaluation
