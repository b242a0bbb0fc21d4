#include "omega_slam/grid/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace omega_slam::grid {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kFar = std::numeric_limits<float>::infinity();

/// The parabolas (x - position)^2 + height that are lowest somewhere, from left to right.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(std::size_t capacity) { parts_.reserve(capacity); }

  void clear() { parts_.clear(); }

  /// Parabolas come with growing positions.
  void add(double position, double height) {
    if (height == kInfinity) {
      return;
    }
    double begin = -kInfinity;
    while (!parts_.empty()) {
      const Part& last = parts_.back();
      begin = (height + position * position - last.height - last.position * last.position) /
              (2.0 * (position - last.position));
      if (begin > last.begin) {
        break;
      }
      parts_.pop_back();
      begin = -kInfinity;
    }
    parts_.push_back({begin, position, height});
  }

  /// Heights at x = 0, 1, 2...
  template <typename Visitor>
  void sample(int count, Visitor&& visit) const {
    std::size_t part = 0;
    for (int x = 0; x < count; ++x) {
      while (part + 1 < parts_.size() && parts_[part + 1].begin <= static_cast<double>(x)) {
        ++part;
      }
      visit(x, parts_.empty() ? kInfinity : parts_[part].at(static_cast<double>(x)));
    }
  }

 private:
  struct Part {
    double begin;  ///< where it begins to be the lowest
    double position;
    double height;
    [[nodiscard]] double at(double x) const { return (x - position) * (x - position) + height; }
  };
  std::vector<Part> parts_;
};

/// First pass: in cells, how far up or down in its column the next obstacle's edge is.
std::vector<float> verticalDistances(const GridGeometry& geometry,
                                     const std::vector<std::uint8_t>& obstacles, Outside outside) {
  std::vector<float> distances(geometry.size());
  const float edge = outside == Outside::kObstacle ? -0.5F : kFar;
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<float> run(width, edge);
  const auto sweep = [&](std::size_t row, bool down) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t i = row * width + column;
      // An obstacle's own centre is within it; from there it is half a cell to the edge.
      run[column] = obstacles[i] != 0 ? -0.5F : run[column] + 1.0F;
      const float distance = std::max(run[column], 0.0F);
      distances[i] = down ? std::min(distances[i], distance) : distance;
    }
  };
  const auto height = static_cast<std::size_t>(geometry.height);
  for (std::size_t row = 0; row < height; ++row) {
    sweep(row, false);
  }
  std::fill(run.begin(), run.end(), edge);
  for (std::size_t row = height; row-- > 0;) {
    sweep(row, true);
  }
  return distances;
}

/// Second pass, in place: over the squares of the first pass's distances along each row.
void spreadAlongRows(const GridGeometry& geometry, Outside outside, std::vector<float>& distances) {
  const double beyond = outside == Outside::kObstacle ? 0.0 : kInfinity;
  LowerEnvelope envelope(2 * static_cast<std::size_t>(geometry.width) + 1);
  for (int row = 0; row < geometry.height; ++row) {
    float* const line = distances.data() + geometry.index({0, row});
    envelope.clear();
    double left = beyond;  // height at the square to the left
    for (int column = 0; column < geometry.width; ++column) {
      const double height = static_cast<double>(line[column]) * static_cast<double>(line[column]);
      envelope.add(column - 0.5, std::min(left, height));
      envelope.add(column, height);
      left = height;
    }
    envelope.add(geometry.width - 0.5, std::min(left, beyond));
    envelope.sample(geometry.width, [&](int column, double square) {
      line[column] = static_cast<float>(geometry.resolution * std::sqrt(std::max(square, 0.0)));
    });
  }
}

}  // namespace

DistanceField::DistanceField(const GridGeometry& geometry, std::vector<std::uint8_t> obstacles,
                             Outside outside)
    : geometry_(geometry), obstacles_(std::move(obstacles)), outside_(outside) {
  if (geometry_.width < 0 || geometry_.height < 0 || obstacles_.size() != geometry_.size()) {
    throw std::invalid_argument("A distance field needs one obstacle flag for each cell.");
  }
  distances_ = verticalDistances(geometry_, obstacles_, outside_);
  spreadAlongRows(geometry_, outside_, distances_);
}

double DistanceField::lowerBound(const Eigen::Vector2d& point) const {
  const Cell cell = geometry_.cellAt(point);
  if (geometry_.contains(cell)) {
    return boundFrom(cell, point);
  }
  if (outside_ == Outside::kObstacle || geometry_.size() == 0) {
    return outside_ == Outside::kObstacle ? 0.0 : kInfinity;
  }
  // Seen from the nearest point of the edge, whatever is in the grid lies at a right angle or more
  // from the way out: both ways are the legs of a triangle whose third side is longer than their
  // hypotenuse.
  const Eigen::Vector2d size(geometry_.width, geometry_.height);
  const Eigen::Vector2d edge =
      point.cwiseMax(geometry_.origin).cwiseMin(geometry_.origin + geometry_.resolution * size);
  const Cell beside = cell.cwiseMax(0).cwiseMin(Cell(geometry_.width - 1, geometry_.height - 1));
  return std::hypot((point - edge).norm(), boundFrom(beside, edge));
}

double DistanceField::boundFrom(const Cell& cell, const Eigen::Vector2d& point) const {
  return std::max(0.0, static_cast<double>(atCell(cell)) - (point - geometry_.center(cell)).norm());
}

double DistanceField::interpolated(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d in_cells =
      (point - geometry_.origin) / geometry_.resolution - Eigen::Vector2d(0.5, 0.5);
  const Eigen::Vector2d low = in_cells.array().floor();
  const Cell cell = low.cast<int>();
  if (!geometry_.contains(cell) || !geometry_.contains(cell + Cell(1, 1)) ||
      std::isinf(atCell(cell))) {  // then there is no obstacle at all
    return lowerBound(point);
  }
  const Eigen::Vector2d share = in_cells - low;
  const auto between = [&](int row) {
    const double left = atCell({cell.x(), row});
    return left + share.x() * (atCell({cell.x() + 1, row}) - left);
  };
  const double below = between(cell.y());
  return below + share.y() * (between(cell.y() + 1) - below);
}

bool DistanceField::isClear(const Eigen::Vector2d& point, double radius) const {
  const Cell cell = geometry_.cellAt(point);
  if (!geometry_.contains(cell)) {
    return outside_ == Outside::kOpen && isClearOfSquares(point, radius);
  }
  constexpr double kRounding = 1e-5;  // [m] distances are floats
  const double from_center = atCell(cell);
  const double offset = (point - geometry_.center(cell)).norm() + kRounding;
  if (from_center - offset >= radius) {
    return true;
  }
  return from_center + offset >= radius && isClearOfSquares(point, radius);
}

bool DistanceField::isClearOfSquares(const Eigen::Vector2d& point, double radius) const {
  const Eigen::Vector2d reach(radius, radius);
  const Cell low = geometry_.cellAt(point - reach);
  const Cell high = geometry_.cellAt(point + reach);
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      if (!isObstacle({column, row})) {
        continue;
      }
      const Eigen::Vector2d corner =
          geometry_.origin + geometry_.resolution * Eigen::Vector2d(column, row);
      const Eigen::Vector2d edge(geometry_.resolution, geometry_.resolution);
      const Eigen::Vector2d nearest = point.cwiseMax(corner).cwiseMin(corner + edge);
      if ((nearest - point).norm() < radius) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace omega_slam::grid
