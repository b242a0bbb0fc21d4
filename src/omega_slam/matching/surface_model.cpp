#include "omega_slam/matching/surface_model.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::matching {

namespace {

constexpr double kSurfaceRadius = 0.3;  // [m] neighbours that make up the surface around a point
constexpr double kLineFlatness = 0.25;  // minor over major axis; above, it is no line
/// [m] by which a search goes farther than it has to, so that it need not be repeated as soon.
constexpr double kBeyond = 0.1;
constexpr double kRounding = 1e-9;    // [m]
constexpr double kEdgeOn = 0.1;       // sine of the angle up to which a surface is seen edge-on
constexpr double kSpotRadius = 0.05;  // [m] root mean square of what is small
constexpr double kLeastNoise = 0.01;  // [m] of a range: three points may look straighter
// Far away the neighbours of a beam lie beyond the radius above. With the point between them they
// are a line if they are not farther than this, about equally far, and straight within:
constexpr double kSparseRadius = 1.5;  // [m]
constexpr double kSparseSlope = 0.06;  // [rad] deviation of the normal

/// Sums over points, given as offsets from one of them, which keeps the digits.
struct Moments {
  std::size_t count{0};
  Eigen::Vector2d sum{0.0, 0.0};
  double xx{0.0};
  double xy{0.0};
  double yy{0.0};

  void add(const Eigen::Vector2d& offset) {
    ++count;
    sum += offset;
    xx += offset.x() * offset.x();
    xy += offset.x() * offset.y();
    yy += offset.y() * offset.y();
  }

  [[nodiscard]] Eigen::Vector2d mean() const { return sum / static_cast<double>(count); }

  [[nodiscard]] Eigen::Matrix2d scatter() const {
    Eigen::Matrix2d squares;
    squares << xx, xy, xy, yy;
    return squares - sum * mean().transpose();
  }
};

SurfaceModel::Partner partnerFrom(const Moments& moments, const Eigen::Vector2d& origin) {
  const Surface surface = fitSurface(moments.scatter(), moments.count);
  return {surface.isLine() ? origin + moments.mean() : origin, surface};
}

}  // namespace

Surface fitSurface(const Eigen::Matrix2d& scatter, std::size_t count) {
  Surface surface;
  if (count < 3) {
    return surface;
  }
  const double middle = 0.5 * (scatter(0, 0) + scatter(1, 1));
  const double skew = 0.5 * (scatter(0, 0) - scatter(1, 1));
  const double half_gap = std::sqrt(skew * skew + scatter(0, 1) * scatter(0, 1));
  const double along = middle + half_gap;
  const double across = std::max(middle - half_gap, 0.0);
  if (across >= kLineFlatness * kLineFlatness * along) {
    surface.is_spot = along <= static_cast<double>(count) * kSpotRadius * kSpotRadius;
    return surface;
  }
  // Of the two forms of the major axis the one that does not cancel.
  const Eigen::Vector2d tangent = scatter(0, 0) > scatter(1, 1)
                                      ? Eigen::Vector2d(along - scatter(1, 1), scatter(0, 1))
                                      : Eigen::Vector2d(scatter(0, 1), along - scatter(0, 0));
  const double length = tangent.norm();
  surface.normal = {-tangent.y() / length, tangent.x() / length};
  const double variance = across / static_cast<double>(count - 2);
  surface.slope_variance = std::max(variance, kLeastNoise * kLeastNoise) / along;
  return surface;
}

bool SurfaceModel::Partner::isSeenFrom(const Eigen::Vector2d& eye) const {
  const Eigen::Vector2d way = eye - point;
  const double before = surface.normal.dot(way);
  return before >= 0.0 || before * before <= kEdgeOn * kEdgeOn * way.squaredNorm();
}

SurfaceModel::SurfaceModel(const Reference& reference)
    : reference_(allPoints(reference)), index_(reference_), partners_(reference_.size()) {
  std::size_t end = 0;
  for (const View& view : reference) {
    end += view.points.size();
    eyes_.push_back({end, view.origin});
  }
}

std::optional<SurfaceModel::Partner> SurfaceModel::partnerOf(const Eigen::Vector2d& p_reference,
                                                             double reach) {
  const auto nearest = index_.nearest(p_reference, reach, {latest_, latest_});
  if (!nearest) {
    return std::nullopt;
  }
  latest_ = nearest->index;
  return *surfaceAt(nearest->index);
}

const SurfaceModel::Partner* SurfaceModel::partnerOf(std::size_t point,
                                                     const Eigen::Vector2d& p_reference,
                                                     double reach) {
  if (point >= findings_.size()) {
    findings_.resize(point + 1);
  }
  Finding& finding = findings_[point];
  const double moved = (p_reference - finding.place).norm();
  if (reference_.empty() || finding.clearance - moved > reach + kRounding) {
    return nullptr;  // nothing can have come that near
  }
  if (moved >= finding.slack) {
    search(finding, p_reference, reach + kBeyond);
  }
  if ((reference_[finding.nearest] - p_reference).squaredNorm() > reach * reach) {
    return nullptr;
  }
  latest_ = finding.nearest;
  return surfaceAt(finding.nearest);
}

/// Where nothing is within reach, the nearest of before stays, which is too far away.
void SurfaceModel::search(Finding& finding, const Eigen::Vector2d& p_reference,
                          double reach) const {
  const auto nearest = index_.nearest(p_reference, reach, {finding.nearest, latest_});
  finding.place = p_reference;
  if (!nearest) {
    finding.clearance = reach;
    finding.slack = -1.0;
    return;
  }
  finding.nearest = nearest->index;
  finding.clearance = std::sqrt(nearest->squared_distance);
  finding.slack = 0.5 * (std::sqrt(nearest->squared_next) - finding.clearance) - kRounding;
}

const SurfaceModel::Partner* SurfaceModel::surfaceAt(std::size_t index) {
  std::optional<Partner>& partner = partners_[index];
  if (!partner) {
    partner = fitAround(index);
    turnToEye(index, *partner);
  }
  return &*partner;
}

void SurfaceModel::turnToEye(std::size_t index, Partner& partner) const {
  const auto eye = std::upper_bound(eyes_.begin(), eyes_.end(), index,
                                    [](std::size_t i, const Eye& e) { return i < e.end; });
  Eigen::Vector2d& normal = partner.surface.normal;
  if (normal.dot(eye->place - partner.point) < 0.0) {
    normal = -normal;
  }
}

SurfaceModel::Partner SurfaceModel::fitAround(std::size_t index) {
  Partner partner = fitSweep(index);
  if (!partner.surface.isLine()) {
    partner = fitNeighbourhood(index);
  }
  if (!partner.surface.isLine() && !partner.surface.is_spot) {
    partner = fitSparse(index);
  }
  return partner;
}

SurfaceModel::Partner SurfaceModel::fitSweep(std::size_t index) const {
  const Eigen::Vector2d& origin = reference_[index];
  const auto isNear = [&](std::size_t i) {
    return (reference_[i] - origin).squaredNorm() <= kSurfaceRadius * kSurfaceRadius;
  };
  std::size_t first = index;
  while (first > 0 && isNear(first - 1)) {
    --first;
  }
  Moments run;
  for (std::size_t i = first; i < reference_.size() && (i <= index || isNear(i)); ++i) {
    run.add(reference_[i] - origin);
  }
  return partnerFrom(run, origin);
}

SurfaceModel::Partner SurfaceModel::fitNeighbourhood(std::size_t index) {
  const Eigen::Vector2d& origin = reference_[index];
  index_.within(origin, kSurfaceRadius, neighbours_);
  Moments around;
  for (const PointIndex::Neighbour& neighbour : neighbours_) {
    around.add(reference_[neighbour.index] - origin);
  }
  return partnerFrom(around, origin);
}

SurfaceModel::Partner SurfaceModel::fitSparse(std::size_t index) const {
  const Eigen::Vector2d& origin = reference_[index];
  if (index == 0 || index + 1 == reference_.size()) {
    return {origin, {}};
  }
  const Eigen::Vector2d before = reference_[index - 1] - origin;
  const Eigen::Vector2d after = reference_[index + 1] - origin;
  const double nearer = std::min(before.norm(), after.norm());
  const double farther = std::max(before.norm(), after.norm());
  if (farther < kSurfaceRadius || farther > std::min(kSparseRadius, 2.0 * nearer)) {
    return {origin, {}};
  }
  Moments three;
  three.add(before);
  three.add({0.0, 0.0});
  three.add(after);
  const Partner partner = partnerFrom(three, origin);
  const bool is_straight = partner.surface.slope_variance <= kSparseSlope * kSparseSlope;
  return is_straight ? partner : Partner{origin, {}};
}

}  // namespace omega_slam::matching
