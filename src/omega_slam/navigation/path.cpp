#include "omega_slam/navigation/path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace omega_slam::navigation {
namespace {

constexpr double kSpacing = 0.25;    // [m] between points that may be skipped
constexpr double kLongestLeg = 6.0;  // [m]
constexpr double kWidestCut = 0.4;   // [m] of a corner's legs that its curve replaces
constexpr double kNarrowestCut = 0.05;
constexpr int kCurvePoints = 5;

/// The same way with more points on it.
Path subdivided(const Path& path) {
  Path result;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d leg = path[i + 1] - path[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(leg.norm() / kSpacing)));
    for (int part = 0; part < parts; ++part) {
      result.emplace_back(path[i] + leg * (static_cast<double>(part) / parts));
    }
  }
  if (!path.empty()) {
    result.push_back(path.back());
  }
  return result;
}

/// The same way without points that lie on a straight line between their neighbours.
Path withoutIdlePoints(const Path& path) {
  Path result;
  for (const Eigen::Vector2d& point : path) {
    if (!result.empty() && (point - result.back()).norm() < 1e-9) {
      continue;
    }
    while (result.size() >= 2) {
      const Eigen::Vector2d before = (result.back() - result[result.size() - 2]).normalized();
      const Eigen::Vector2d after = (point - result.back()).normalized();
      if ((before - after).norm() > 1e-9) {
        break;
      }
      result.pop_back();
    }
    result.push_back(point);
  }
  return result;
}

Path curve(const Eigen::Vector2d& start, const Eigen::Vector2d& corner,
           const Eigen::Vector2d& end) {
  Path points;
  for (int i = 0; i < kCurvePoints; ++i) {
    const double t = static_cast<double>(i) / (kCurvePoints - 1);
    points.emplace_back((1.0 - t) * (1.0 - t) * start + 2.0 * t * (1.0 - t) * corner + t * t * end);
  }
  return points;
}

bool isFree(const Path& path, const Costmap& costmap, double radius) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!costmap.isFree(path[i], path[i + 1], radius)) {
      return false;
    }
  }
  return true;
}

}  // namespace

double lengthOf(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    length += (path[i + 1] - path[i]).norm();
  }
  return length;
}

PathMeasure::PathMeasure(Path path) : path_(std::move(path)) {
  double along = 0.0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    along += i > 0 ? (path_[i] - path_[i - 1]).norm() : 0.0;
    along_.push_back(along);
  }
}

Eigen::Vector2d PathMeasure::at(double along) const {
  const auto next = std::upper_bound(along_.begin(), along_.end(), along);
  if (next == along_.begin()) {
    return path_.front();
  }
  if (next == along_.end()) {
    return path_.back();
  }
  const auto i = static_cast<std::size_t>(next - along_.begin());
  const double share = (along - along_[i - 1]) / (along_[i] - along_[i - 1]);
  return path_[i - 1] + (path_[i] - path_[i - 1]) * share;
}

PathMeasure::Projection PathMeasure::project(const Eigen::Vector2d& point, double from,
                                             double to) const {
  Projection best{std::clamp(from, 0.0, length()), (at(from) - point).norm()};
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    const double leg = along_[i + 1] - along_[i];
    if (along_[i + 1] < from || along_[i] > to || leg <= 0.0) {
      continue;
    }
    const Eigen::Vector2d direction = (path_[i + 1] - path_[i]) / leg;
    const double along = std::clamp(along_[i] + direction.dot(point - path_[i]),
                                    std::max(along_[i], from), std::min(along_[i + 1], to));
    const double distance = (at(along) - point).norm();
    if (distance < best.distance) {
      best = {along, distance};
    }
  }
  return best;
}

double ClearanceCost::perMetre(double clearance) const {
  if (clearance >= preferred) {
    return 1.0;
  }
  const double lack = std::min(1.0, (preferred - clearance) / (preferred - radius));
  return 1.0 + weight * lack * lack;
}

double ClearanceCost::ofLine(const Costmap& costmap, const Eigen::Vector2d& from,
                             const Eigen::Vector2d& to) const {
  const double length = (to - from).norm();
  const int steps =
      std::max(1, static_cast<int>(std::ceil(2.0 * length / costmap.geometry().resolution)));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += perMetre(costmap.clearance(from + (to - from) * ((i + 0.5) / steps)));
  }
  return length * sum / steps;
}

double ClearanceCost::ofPath(const Costmap& costmap, const Path& path) const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    sum += ofLine(costmap, path[i], path[i + 1]);
  }
  return sum;
}

Path shorten(const Path& path, const Costmap& costmap, const ClearanceCost& cost) {
  const Path points = subdivided(withoutIdlePoints(path));
  std::vector<double> best(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(points.size(), 0);
  for (std::size_t to = 0; to < points.size(); ++to) {
    best[to] = to == 0 ? 0.0 : best[to];
    for (std::size_t from = to; from-- > 0;) {
      const double length = (points[to] - points[from]).norm();
      if (to - from > 1 && length > kLongestLeg) {
        break;
      }
      if (best[from] + length >= best[to] ||
          (to - from > 1 && !costmap.isFree(points[from], points[to], cost.radius))) {
        continue;
      }
      const double total = best[from] + cost.ofLine(costmap, points[from], points[to]);
      if (total < best[to]) {
        best[to] = total;
        before[to] = from;
      }
    }
  }
  Path result;
  for (std::size_t i = points.size(); i > 0; i = i == 1 ? 0 : before[i - 1] + 1) {
    result.push_back(points[i - 1]);
  }
  std::reverse(result.begin(), result.end());
  return withoutIdlePoints(result);
}

Path roundCorners(const Path& path, const Costmap& costmap, double radius) {
  if (path.size() < 3) {
    return path;
  }
  Path result{path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d in = path[i] - path[i - 1];
    const Eigen::Vector2d out = path[i + 1] - path[i];
    Path corner{path[i]};
    for (double cut = std::min({kWidestCut, 0.5 * in.norm(), 0.5 * out.norm()});
         cut >= kNarrowestCut; cut *= 0.5) {
      Path rounded =
          curve(path[i] - cut * in.normalized(), path[i], path[i] + cut * out.normalized());
      if (isFree(rounded, costmap, radius)) {
        corner = std::move(rounded);
        break;
      }
    }
    result.insert(result.end(), corner.begin(), corner.end());
  }
  result.push_back(path.back());
  return result;
}

}  // namespace omega_slam::navigation
