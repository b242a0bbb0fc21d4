#include "nodes/common/scan_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace omega_slam {
namespace {

constexpr double kLastResort = 20.0;  // times the patience

}  // namespace

ScanQueue::ScanQueue(double patience, std::size_t capacity)
    : patience_(patience), capacity_(capacity) {}

std::optional<WaitingScan> ScanQueue::push(WaitingScan scan) {
  const auto place = std::upper_bound(
      scans_.begin(), scans_.end(), scan,
      [](const WaitingScan& a, const WaitingScan& b) { return a.scan.stamp < b.scan.stamp; });
  scans_.insert(place, std::move(scan));
  if (scans_.size() > capacity_) {
    return pop();
  }
  return std::nullopt;
}

WaitingScan ScanQueue::pop() {
  WaitingScan scan = std::move(scans_.front());
  scans_.pop_front();
  return scan;
}

std::vector<WaitingScan> ScanQueue::giveUp(std::optional<double> newest_odometry, double now) {
  if (scans_.empty()) {
    return {};
  }
  const double newest = std::max(scans_.back().scan.stamp, newest_odometry.value_or(0.0));
  const auto is_patient = [&](const WaitingScan& scan) {
    const double waited = now - scan.arrival;
    return waited <= patience_ ||
           (newest - scan.end <= patience_ && waited <= kLastResort * patience_);
  };
  const auto given_up = std::stable_partition(scans_.begin(), scans_.end(), is_patient);
  std::vector<WaitingScan> result(std::make_move_iterator(given_up),
                                  std::make_move_iterator(scans_.end()));
  scans_.erase(given_up, scans_.end());
  return result;
}

}  // namespace omega_slam
