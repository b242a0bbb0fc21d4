#include "omega_slam/sensing/contact.h"

#include <algorithm>

namespace omega_slam::sensing {
namespace {

constexpr double kSlack = 0.03;  // [m] beyond the robot, so that its own place is not in contact
constexpr double kStep = 0.04;   // [m] between marks: no cell between them is left out

}  // namespace

std::vector<Eigen::Vector2d> contactMarks(const std::vector<Eigen::Vector2d>& contacts,
                                          const geometry::Pose2& T_map_base, double radius) {
  std::vector<Eigen::Vector2d> marks;
  for (const Eigen::Vector2d& p_base : contacts) {
    if (!p_base.allFinite() || p_base.norm() <= 0.0) {
      continue;
    }
    const Eigen::Vector2d ahead = p_base.normalized();
    const Eigen::Vector2d aside(-ahead.y(), ahead.x());
    const double distance = std::max(p_base.norm(), radius + kSlack);
    const int steps = static_cast<int>(radius / kStep);
    for (int i = -steps; i <= steps; ++i) {
      marks.emplace_back(T_map_base * Eigen::Vector2d(distance * ahead + i * kStep * aside));
    }
  }
  return marks;
}

}  // namespace omega_slam::sensing
