#include "nodes/common/map_worker.h"

#include <ros/time.h>

#include <algorithm>
#include <string>
#include <utility>

#include "omega_slam/mapping/map_update.h"

namespace omega_slam {

MapWorker::MapWorker(const mapping::OccupancyMapperConfig& config, double interval,
                     Diagnostics& diagnostics, Drawn drawn)
    : interval_(interval),
      diagnostics_(diagnostics),
      drawn_(std::move(drawn)),
      mapper_(config),
      thread_(&MapWorker::work, this) {}

MapWorker::~MapWorker() { stop(); }

void MapWorker::show(std::vector<mapping::PlacedSweep> keyframes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  keyframes_ = std::move(keyframes);
  ++version_;
  if (keyframes_.empty()) {
    newest_.reset();  // nobody shall be served the map of a run that is over
  }
  wake_.notify_one();
}

DrawnMapPtr MapWorker::newest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_;
}

DrawnMapPtr MapWorker::complete(double patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t wanted = version_;
  is_urgent_ = true;
  wake_.notify_one();
  finished_.wait_for(lock, std::chrono::duration<double>(patience),
                     [&] { return drawn_version_ >= wanted || is_stopped_; });
  return newest_;
}

void MapWorker::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopped_ = true;
    wake_.notify_one();
    finished_.notify_all();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

void MapWorker::work() {
  std::vector<mapping::PlacedSweep> keyframes;
  std::uint64_t version = 0;
  while (take(keyframes, version)) {
    const DrawnMapPtr map = draw(keyframes);
    bool is_new = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      // A reset may have come meanwhile; then this map is of a run that is over.
      const DrawnMapPtr valid = keyframes_.empty() ? nullptr : map;
      is_new = valid && valid != newest_;
      newest_ = valid;
      drawn_version_ = version;
      finished_.notify_all();
    }
    if (is_new) {
      drawn_(map);
    }
  }
}

bool MapWorker::take(std::vector<mapping::PlacedSweep>& keyframes, std::uint64_t& version) {
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait(lock, [this] { return is_stopped_ || version_ != drawn_version_; });
  waitForTurn(lock);
  is_urgent_ = false;
  keyframes = keyframes_;
  version = version_;
  if (!keyframes
           .empty()) {  // an empty map is not published, and must not hold up the first real one
    next_turn_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>(interval_));
    next_simulated_turn_ = ros::Time::now().toSec() + interval_;
  }
  return !is_stopped_;
}

/// Simulated time may run fast or stand still: the turn comes by whichever clock has it first.
void MapWorker::waitForTurn(std::unique_lock<std::mutex>& lock) {
  constexpr std::chrono::milliseconds kLook(100);
  const auto isDue = [this] {
    return is_stopped_ || is_urgent_ || Clock::now() >= next_turn_ ||
           (ros::Time::isSimTime() && ros::Time::now().toSec() >= next_simulated_turn_);
  };
  while (!isDue()) {
    const auto look = ros::Time::isSimTime() ? Clock::now() + kLook : next_turn_;
    wake_.wait_until(lock, std::min(look, next_turn_));
  }
}

DrawnMapPtr MapWorker::draw(const std::vector<mapping::PlacedSweep>& keyframes) {
  const auto begin = Clock::now();
  const mapping::UpdateReport report = mapping::update(mapper_, keyframes);
  for (const std::string& refusal : report.refusals) {
    diagnostics_.reject(refusal);
  }
  DrawnMapPtr before = newest();
  if (before && !report.hasChanged()) {
    return before;
  }
  auto map = std::make_shared<DrawnMap>();
  map->snapshot = mapper_.snapshot();
  map->keyframes = mapper_.drawn().size();
  for (const mapping::PlacedSweep& placed : keyframes) {
    map->stamp = std::max(map->stamp, placed.sweep->stamp);
  }
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  diagnostics_.set("last drawing [ms]", took.count());
  diagnostics_.set("last drawing, keyframes", static_cast<double>(report.drawn));
  diagnostics_.set("keyframes in the map", static_cast<double>(map->keyframes));
  return mapping::boundsOf(map->snapshot.tiles).isEmpty() ? nullptr : map;
}

}  // namespace omega_slam
