#include "omega_slam/matching/ray_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::matching {

using geometry::kPi;
using geometry::Pose2;

namespace {

constexpr double kJoin = 0.05;         // [m] neighbours that are no farther apart are joined,
constexpr double kJoinPerRange = 0.1;  // or so much farther for each metre of range
constexpr double kMinOverlap = 0.7;    // share of the rays that must be compared

constexpr double kTurn = kRayDirections;  // a full turn, in steps from direction to direction
constexpr double kWidest = kTurn / 8.0;   // wider lines pass by the laser: no surface it sees
constexpr double kFarthest = 1e8;         // [m]
constexpr float kNoRange = 1e9F;          // [m] marks a direction in which nothing is seen

/// A point as seen from the center.
struct Ray {
  double direction;  // [0, kTurn]
  double range;      // [m]
};

/// The arc tangent is the polynomial 4.4.47 of Abramowitz and Stegun, "Handbook of Mathematical
/// Functions", 1964: right to 1e-5 rad, a six-hundredth of a step.
Ray toRay(double x, double y) {
  const double width = std::abs(x);
  const double height = std::abs(y);
  const double slope =
      std::min(width, height) / std::max({width, height, std::numeric_limits<double>::min()});
  const double s = slope * slope;
  double angle =
      slope * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  angle = height > width ? 0.5 * kPi - angle : angle;
  angle = x < 0.0 ? kPi - angle : angle;
  angle = y < 0.0 ? 2.0 * kPi - angle : angle;
  return {angle * (kTurn / (2.0 * kPi)), std::sqrt(x * x + y * y)};
}

void draw(int direction, double range, RayRanges& ranges) {
  static_assert((kRayDirections & (kRayDirections - 1)) == 0, "the mask wraps powers of two");
  float& nearest = ranges[direction & (kRayDirections - 1)];
  nearest = std::min(nearest, static_cast<float>(range));
}

/// Draws what lies between two rays, the last direction included and the first not, so that lines
/// that continue each other draw each direction once.
void drawLine(const Ray& a, const Ray& b, RayRanges& ranges) {
  double turn = b.direction - a.direction;
  turn = turn > 0.5 * kTurn ? turn - kTurn : turn;
  turn = turn < -0.5 * kTurn ? turn + kTurn : turn;
  if (std::abs(turn) > kWidest) {
    return;
  }
  const double start = a.direction + kTurn;  // so that nothing below is negative
  const double begin = std::min(start, start + turn);
  const double end = std::max(start, start + turn);
  const double slope = (b.range - a.range) / turn;
  for (int k = static_cast<int>(begin) + 1; k <= end; ++k) {
    draw(k, a.range + slope * (k - start), ranges);
  }
}

void drawScan(const RayScan& scan, const Pose2& T_center_scan, RayRanges& ranges) {
  const Eigen::Matrix2d rotation = T_center_scan.rotation();
  const Eigen::Vector2d translation = T_center_scan.translation();
  Ray last{};
  bool joinable = false;
  for (const RayScan::Vertex& vertex : scan.vertices()) {
    const Eigen::Vector2d p_center = rotation * vertex.p_scan + translation;
    const Ray ray = toRay(p_center.x(), p_center.y());
    if (!(ray.range < kFarthest)) {  // nor NaN
      joinable = false;
      continue;
    }
    if (vertex.joined && joinable) {
      drawLine(last, ray, ranges);
    } else if (vertex.lone) {
      draw(static_cast<int>(ray.direction + 0.5), ray.range, ranges);
    }
    last = ray;
    joinable = true;
  }
}

/// 1 in directions in which both see something, 0 elsewhere.
RayRanges seenByBoth(const RayRanges& a, const RayRanges& b) {
  return (kNoRange - a.max(b)).min(1.0F);
}

double countSeen(const RayRanges& ranges) { return seenByBoth(ranges, ranges).sum(); }

}  // namespace

RayScan::RayScan(const View& scan, std::size_t most_points) {
  const Points& points = scan.points;
  const std::size_t stride = points.size() / std::max<std::size_t>(most_points, 1) + 1;
  const auto continues = [&](std::size_t i) {
    return (points[i] - points[i - 1]).norm() <=
           kJoin + kJoinPerRange * (points[i] - scan.origin).norm();
  };
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    if (i == points.size() || !continues(i)) {
      addLine(points, begin, i, stride);
      begin = i;
    }
  }
  RayRanges ranges = RayRanges::Constant(kNoRange);
  drawScan(*this, {-scan.origin.x(), -scan.origin.y(), 0.0}, ranges);
  rays_ = countSeen(ranges);
}

void RayScan::addLine(const Points& points, std::size_t begin, std::size_t end,
                      std::size_t stride) {
  const std::size_t last = end - 1;
  for (std::size_t i = begin; i < last; i += stride) {
    vertices_.push_back({points[i], i > begin, false});
  }
  vertices_.push_back({points[last], last > begin, last == begin});
}

RayReference::RayReference(const Reference& reference, double cap)
    : cap_(cap), ranges_(RayRanges::Constant(kNoRange)) {
  if (reference.empty()) {
    return;
  }
  const View& newest = reference.back();
  Pose2 T_reference_center{newest.origin.x(), newest.origin.y(), 0.0};
  if (!newest.points.empty()) {
    const Eigen::Vector2d first = newest.points.front() - newest.origin;
    T_reference_center.theta = std::atan2(first.y(), first.x());
  }
  T_center_reference_ = T_reference_center.inverse();
  for (std::size_t i = 0; i + 1 < reference.size(); ++i) {
    drawScan(RayScan(reference[i]), T_center_reference_, ranges_);
  }
  RayRanges seen_last = RayRanges::Constant(kNoRange);
  drawScan(RayScan(newest), T_center_reference_, seen_last);
  ranges_ = (seen_last < kNoRange).select(seen_last, ranges_);
  rays_ = countSeen(ranges_);
}

double RayReference::squaredError(const RayScan& scan, const Pose2& T_reference_scan) const {
  RayRanges ranges = RayRanges::Constant(kNoRange);
  drawScan(scan, T_center_reference_ * T_reference_scan, ranges);
  const RayRanges both = seenByBoth(ranges, ranges_);
  const double compared = both.sum();
  const double sum = (both * (ranges - ranges_).abs().min(static_cast<float>(cap_)).square()).sum();
  const double required = kMinOverlap * std::min(scan.rays(), rays_);
  const double lacking = std::max(required - compared, 0.0);
  const double all = compared + lacking;
  return all > 0.0 ? (sum + lacking * cap_ * cap_) / all : cap_ * cap_;
}

}  // namespace omega_slam::matching
