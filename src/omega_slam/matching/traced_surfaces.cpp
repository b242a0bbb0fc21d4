#include "omega_slam/matching/traced_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "omega_slam/matching/tiled_grid.h"

namespace omega_slam::matching {

namespace {

// Neighbouring returns farther apart than this, at their range, are not of one surface: [m], and
// [m/m], which for beams 1 degree apart is a surface seen at 20 degrees.
constexpr double kGap = 0.1;
constexpr double kGapPerRange = 0.05;
constexpr double kLongestGap = 0.5;  // [m] at any range
// Returns nearer than this make up the line at a place: [m], [m/m].
constexpr double kRadius = 0.15;
constexpr double kRadiusPerRange = 0.03;

/// Finds the patches of a view, with two ends that move along the sweep.
class PatchTracer {
 public:
  explicit PatchTracer(const View& view) : view_(view), sums_(1, Sums::Zero()) {
    sums_.reserve(view.points.size() + 1);
    for (const Eigen::Vector2d& point : view.points) {
      const Eigen::Vector2d p = point - view.origin;
      Sums term;
      term << p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
      sums_.push_back(sums_.back() + term);
    }
  }

  [[nodiscard]] std::vector<SurfacePatch> trace() const {
    const Points& points = view_.points;
    std::vector<SurfacePatch> patches;
    patches.reserve(points.size());
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double radius = kRadius + kRadiusPerRange * rangeOf(i);
      if (i > 0 && !patches.back().joins_next) {
        first = i;
      }
      while ((points[first] - points[i]).norm() > radius) {
        ++first;
      }
      last = std::max(last, i);
      while (joinsNext(last) && (points[last + 1] - points[i]).norm() <= radius) {
        ++last;
      }
      patches.push_back(fit(i, first, last));
    }
    return patches;
  }

 private:
  using Sums = Eigen::Matrix<double, 5, 1>;  // of x, y, x^2, x y, y^2

  [[nodiscard]] double rangeOf(std::size_t i) const {
    return (view_.points[i] - view_.origin).norm();
  }

  [[nodiscard]] bool joinsNext(std::size_t i) const {
    const double longest = std::min(kGap + kGapPerRange * rangeOf(i), kLongestGap);
    return i + 1 < view_.points.size() && (view_.points[i + 1] - view_.points[i]).norm() <= longest;
  }

  /// The patch around return i, from the returns `first` to `last`.
  [[nodiscard]] SurfacePatch fit(std::size_t i, std::size_t first, std::size_t last) const {
    const std::size_t count = last - first + 1;
    const Sums sums = sums_[last + 1] - sums_[first];
    const Eigen::Vector2d mean = sums.head<2>() / static_cast<double>(count);
    Eigen::Matrix2d scatter;
    scatter << sums[2], sums[3], sums[3], sums[4];
    scatter -= static_cast<double>(count) * mean * mean.transpose();
    SurfacePatch patch;
    patch.hit = view_.points[i];
    patch.surface = fitSurface(scatter, count);
    patch.joins_next = joinsNext(i);
    Eigen::Vector2d& normal = patch.surface.normal;
    const Eigen::Vector2d ray = patch.hit - view_.origin;
    normal = normal.dot(ray) > 0.0 ? Eigen::Vector2d(-normal) : normal;
    patch.point = patch.hit - normal.dot(ray - mean) * normal;
    return patch;
  }

  const View& view_;
  // [i]: over the returns before i, seen from the laser, where numbers are small and lose few
  // digits. Those of any stretch are a difference.
  std::vector<Sums> sums_;
};

/// Squares of a grid, each of which is taken once.
class Squares {
 public:
  /// @param box that holds all places
  Squares(const Eigen::AlignedBox2d& box, double side) : side_(side) {
    if (!box.isEmpty()) {
      taken_ = {squareAt(box.min()), squareAt(box.max())};
    }
  }

  /// Whether nobody has taken this place's square before.
  [[nodiscard]] bool take(const Eigen::Vector2d& place) {
    const grid::Cell square = squareAt(place);
    std::uint8_t& taken = taken_(square.x(), square.y());
    const bool is_first = taken == 0;
    taken = 1;
    return is_first;
  }

 private:
  [[nodiscard]] grid::Cell squareAt(const Eigen::Vector2d& place) const {
    return (place / side_).array().floor().cast<int>();
  }

  double side_;
  TiledGrid<std::uint8_t> taken_;
};

}  // namespace

std::vector<SurfacePatch> tracePatches(const View& view) { return PatchTracer(view).trace(); }

TracedSurfaces traceSurfaces(const Reference& reference, double spacing) {
  TracedSurfaces surfaces;
  Eigen::AlignedBox2d box;
  for (auto view = reference.rbegin(); view != reference.rend(); ++view) {
    for (const SurfacePatch& patch : tracePatches(*view)) {
      surfaces.patches.push_back(patch);
      box.extend(patch.point);
    }
  }
  Squares squares(box, spacing);
  const auto sample = [&](const Eigen::Vector2d& place, std::size_t patch) {
    if (squares.take(place)) {
      surfaces.samples.push_back({place, patch});
    }
  };
  for (std::size_t i = 0; i < surfaces.patches.size(); ++i) {
    const SurfacePatch& patch = surfaces.patches[i];
    sample(patch.point, i);
    if (patch.joins_next) {
      const Eigen::Vector2d gap = surfaces.patches[i + 1].point - patch.point;
      const int steps = static_cast<int>(std::ceil(gap.norm() / spacing));
      for (int step = 1; step < steps; ++step) {
        // Half of the way is of this patch, half of the next one.
        sample(patch.point + gap * step / steps, 2 * step < steps ? i : i + 1);
      }
    }
  }
  return surfaces;
}

Points thinned(const Points& points, double spacing) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points) {
    box.extend(point);
  }
  Squares squares(box, spacing);
  Points few;
  std::copy_if(points.begin(), points.end(), std::back_inserter(few),
               [&](const Eigen::Vector2d& point) { return squares.take(point); });
  return few;
}

}  // namespace omega_slam::matching
