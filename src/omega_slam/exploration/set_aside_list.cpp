#include "omega_slam/exploration/set_aside_list.h"

#include <algorithm>

namespace omega_slam::exploration {
namespace {

constexpr double kSamePlace = 0.4;  // [m] within which two centroids are of one frontier

}  // namespace

const SetAside* SetAsideList::find(const Eigen::Vector2d& place) const {
  const auto found = std::find_if(
      entries_.begin(), entries_.end(),
      [&place](const SetAside& entry) { return (entry.place - place).norm() <= kSamePlace; });
  return found == entries_.end() ? nullptr : &*found;
}

bool SetAsideList::isLeftAlone(const Eigen::Vector2d& place, double now, int max_attempts) const {
  const SetAside* entry = find(place);
  return entry != nullptr &&
         (entry->until > now || static_cast<int>(entry->tried.size()) >= max_attempts);
}

std::vector<Eigen::Vector2d> SetAsideList::triedFor(const Eigen::Vector2d& place) const {
  const SetAside* entry = find(place);
  return entry == nullptr ? std::vector<Eigen::Vector2d>{} : entry->tried;
}

void SetAsideList::add(const Eigen::Vector2d& place, const Eigen::Vector2d& viewpoint, double until,
                       bool reached) {
  const SetAside* known = find(place);
  if (known == nullptr) {
    entries_.push_back({place, {}, 0.0, 0});
    known = &entries_.back();
  }
  SetAside& entry = entries_[static_cast<std::size_t>(known - entries_.data())];
  entry.place = place;
  entry.tried.push_back(viewpoint);
  entry.until = until;
  entry.failures += reached ? 0 : 1;
}

bool SetAsideList::release(double now, int max_attempts) {
  bool released = false;
  for (SetAside& entry : entries_) {
    if (entry.until > now && entry.failures == 0 &&
        static_cast<int>(entry.tried.size()) < max_attempts) {
      entry.until = now;
      released = true;
    }
  }
  return released;
}

bool SetAsideList::isWaiting(double now, int max_attempts) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const SetAside& entry) {
    return entry.until > now && static_cast<int>(entry.tried.size()) < max_attempts;
  });
}

void SetAsideList::move(const geometry::MapMotion& motion) {
  for (SetAside& entry : entries_) {
    entry.place = motion.apply(entry.place);
    for (Eigen::Vector2d& viewpoint : entry.tried) {
      viewpoint = motion.apply(viewpoint);
    }
  }
}

}  // namespace omega_slam::exploration
