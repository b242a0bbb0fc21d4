#include "omega_slam/grid/pane.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::grid {
namespace {

constexpr double kWidest = 2.1;       // [m] of a pane; two doors side by side are narrower
constexpr double kBehind = 0.6;       // [m] behind each end in which the wall is looked for:
constexpr double kRunsOn = 0.26;      // [m] of it must be seen
constexpr double kBeside = 0.35;      // [m] beside a wall in line, floor is known
constexpr double kThickness = 0.08;   // [m] a wall may lie so far beside the pane's line
constexpr double kObstacle = 0.12;    // [m] an obstacle of the map that is nearer was touched
constexpr double kMostOblique = 0.5;  // [rad] between the pane and across the normal
constexpr int kDirections = 33;       // that are tried: the ends of the longest move by a cell
constexpr std::int8_t kBlocked = 50;  // [%] from which a cell is an obstacle
constexpr double kSlack = 0.03;  // [m] beyond the robot, so that its own place is not in contact
constexpr double kStep = 0.04;   // [m] between marks

/// A map along a line that is as wide as a wall is thick.
class Band {
 public:
  /// @param beyond [m] roughly across the direction: on the other side than the robot
  Band(const OccupancyGrid& map, const Eigen::Vector2d& start, const Eigen::Vector2d& direction,
       const Eigen::Vector2d& beyond)
      : map_(map), start_(start), along_(direction), across_(-direction.y(), direction.x()) {
    across_ *= across_.dot(beyond) < 0.0 ? -1.0 : 1.0;
  }

  [[nodiscard]] bool isBlockedAt(double distance) const {
    const double step = 0.5 * map_.geometry.resolution;
    for (double side = -kThickness; side <= kThickness; side += step) {
      const Cell cell = map_.geometry.cellAt(start_ + distance * along_ + side * across_);
      if (map_.geometry.contains(cell) && map_.at(cell) >= kBlocked) {
        return true;
      }
    }
    return false;
  }

  /// Whether the robot's side is known to be free there: along a wall it is, in one it is not.
  [[nodiscard]] bool isFreeBeside(double distance) const {
    const Cell cell = map_.geometry.cellAt(start_ + distance * along_ - kBeside * across_);
    return map_.geometry.contains(cell) && map_.at(cell) >= 0 && map_.at(cell) < kBlocked;
  }

  /// What ends the line.
  struct End {
    double distance{0.0};  ///< [m]
    double wall{0.0};      ///< [m] that are seen of a wall in line behind it
  };
  [[nodiscard]] std::optional<End> end() const {
    const double step = 0.5 * map_.geometry.resolution;
    End end;
    while (!isBlockedAt(end.distance)) {
      end.distance += step;
      if (end.distance > kWidest) {
        return std::nullopt;
      }
    }
    for (double behind = step; behind <= kBehind; behind += step) {
      const double there = end.distance + behind;
      end.wall += isBlockedAt(there) && isFreeBeside(there) ? step : 0.0;
    }
    return end;
  }

 private:
  const OccupancyGrid& map_;
  Eigen::Vector2d start_;
  Eigen::Vector2d along_;
  Eigen::Vector2d across_;
};

bool isBesideObstacle(const OccupancyGrid& map, const Eigen::Vector2d& point) {
  const Cell here = map.geometry.cellAt(point);
  const int reach = static_cast<int>(std::ceil(kObstacle / map.geometry.resolution));
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Cell cell = here + Cell(x, y);
      if (map.geometry.contains(cell) && map.at(cell) >= kBlocked &&
          (map.geometry.center(cell) - point).norm() < kObstacle) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::optional<Pane> findPane(const OccupancyGrid& map, const Eigen::Vector2d& touched,
                             const Eigen::Vector2d& normal) {
  const Eigen::Vector2d in_map = touched - map.geometry.origin;
  const bool is_inside = touched.allFinite() && in_map.minCoeff() >= 0.0 &&
                         in_map.x() < map.geometry.width * map.geometry.resolution &&
                         in_map.y() < map.geometry.height * map.geometry.resolution;
  if (!is_inside || !normal.allFinite() || normal.norm() <= 0.0 || isBesideObstacle(map, touched)) {
    return std::nullopt;
  }
  const double across = std::atan2(normal.x(), -normal.y());
  std::optional<Pane> shortest;
  double least = kWidest;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = across + kMostOblique * (2.0 * i / (kDirections - 1) - 1.0);
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const auto ahead = Band(map, touched, along, normal).end();
    const auto back = ahead ? Band(map, touched, -along, normal).end() : std::nullopt;
    if (!back || std::min(ahead->wall, back->wall) < kRunsOn) {
      continue;
    }
    if (const double width = ahead->distance + back->distance; width < least) {
      least = width;
      shortest = Pane{touched - back->distance * along, touched + ahead->distance * along};
    }
  }
  return shortest;
}

std::vector<Eigen::Vector2d> paneMarks(const OccupancyGrid& map,
                                       const std::vector<Eigen::Vector2d>& contacts,
                                       const geometry::Pose2& T_map_base, double radius) {
  const Eigen::Vector2d robot = T_map_base.translation();
  std::vector<Eigen::Vector2d> marks;
  for (const Eigen::Vector2d& p_base : contacts) {
    const Eigen::Vector2d touched = T_map_base * p_base;
    const auto pane = findPane(map, touched, touched - robot);
    if (!pane) {
      continue;
    }
    const Eigen::Vector2d way = pane->to - pane->from;
    Eigen::Vector2d away = Eigen::Vector2d(-way.y(), way.x()).normalized();
    away *= away.dot(touched - robot) < 0.0 ? -1.0 : 1.0;
    const double spare = std::max(0.0, radius + kSlack - p_base.norm());
    const int steps = static_cast<int>(std::ceil(way.norm() / kStep));
    for (int i = 0; i <= steps; ++i) {
      const Eigen::Vector2d mark =
          pane->from + way * (static_cast<double>(i) / steps) + spare * away;
      if ((mark - robot).norm() >= radius + kSlack) {
        marks.push_back(mark);
      }
    }
  }
  return marks;
}

}  // namespace omega_slam::grid
