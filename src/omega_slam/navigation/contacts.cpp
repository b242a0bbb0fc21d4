#include "omega_slam/navigation/contacts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace omega_slam::navigation {
namespace {

constexpr double kRim = 1.0;       // [m] of the field around what it holds: near it, it is exact
constexpr double kReach = 100.0;   // [m] about the newest; it bounds the field
constexpr double kFarthest = 1e6;  // [m] farther away, cells can't be counted

bool isCountable(const Eigen::Vector2d& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= kFarthest;
}

}  // namespace

Contacts::Contacts(double resolution) { lattice_.resolution = resolution; }

void Contacts::add(const std::vector<Eigen::Vector2d>& points, double until) {
  bool grows = false;
  for (const Eigen::Vector2d& point : points) {
    if (!isCountable(point)) {
      continue;
    }
    const grid::Cell cell = lattice_.cellAt(point);
    const auto known = std::find_if(marks_.begin(), marks_.end(), [&](const Mark& mark) {
      return lattice_.cellAt(mark.point) == cell;
    });
    if (known != marks_.end()) {
      known->until = std::max(known->until, until);
    } else {
      marks_.push_back({point, until});
      grows = true;
    }
  }
  if (grows) {
    const Eigen::Vector2d newest = marks_.back().point;
    drop([&](const Mark& mark) { return (mark.point - newest).cwiseAbs().maxCoeff() > kReach; });
    rebuild();
  }
}

void Contacts::move(const geometry::MapMotion& motion) {
  bool changes = false;
  for (Mark& mark : marks_) {
    const grid::Cell before = lattice_.cellAt(mark.point);
    const Eigen::Vector2d moved = motion.apply(mark.point);
    mark.point = isCountable(moved) ? moved : mark.point;
    changes = changes || lattice_.cellAt(mark.point) != before;
  }
  if (changes) {
    rebuild();
  }
}

void Contacts::expire(double now) {
  if (drop([now](const Mark& mark) { return mark.until <= now; })) {
    rebuild();
  }
}

template <typename Predicate>
bool Contacts::drop(Predicate&& is_old) {
  const auto old = std::remove_if(marks_.begin(), marks_.end(), is_old);
  const bool any = old != marks_.end();
  marks_.erase(old, marks_.end());
  return any;
}

void Contacts::forget() {
  marks_.clear();
  rebuild();
}

void Contacts::rebuild() {
  if (marks_.empty()) {
    field_ = {};
    return;
  }
  grid::Cell low = lattice_.cellAt(marks_.front().point);
  grid::Cell high = low;
  for (const Mark& mark : marks_) {
    low = low.cwiseMin(lattice_.cellAt(mark.point));
    high = high.cwiseMax(lattice_.cellAt(mark.point));
  }
  const int rim = static_cast<int>(std::ceil(kRim / lattice_.resolution));
  low.array() -= rim;
  high.array() += rim;
  grid::GridGeometry box = lattice_;
  box.origin = box.resolution * low.cast<double>();
  box.width = high.x() - low.x() + 1;
  box.height = high.y() - low.y() + 1;
  std::vector<std::uint8_t> obstacles(box.size());
  for (const Mark& mark : marks_) {
    obstacles[box.index(lattice_.cellAt(mark.point) - low)] = 1;
  }
  field_ = grid::DistanceField(box, std::move(obstacles), grid::Outside::kOpen);
}

}  // namespace omega_slam::navigation
