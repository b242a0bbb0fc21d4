#include "nodes/common/loop_search.h"

#include <algorithm>
#include <utility>

namespace omega_slam {

LoopSearch::LoopSearch(const slam::LoopCloserConfig& config, std::uint64_t run, Found found)
    : found_(std::move(found)),
      closer_(config),
      run_(run),
      new_run_(run),
      thread_(&LoopSearch::work, this) {}

LoopSearch::~LoopSearch() { stop(); }

void LoopSearch::addKeyframe(slam::KeyframePtr keyframe) {
  const std::lock_guard<std::mutex> lock(mutex_);
  new_keyframes_.push_back(std::move(keyframe));  // of no use without poses: nobody is woken
}

void LoopSearch::setPoses(std::vector<geometry::Pose2> T_map_keyframes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  new_poses_ = std::move(T_map_keyframes);
  has_mail_ = true;
  mail_.notify_one();
}

void LoopSearch::reset(std::uint64_t run) {
  const std::lock_guard<std::mutex> lock(mutex_);
  new_keyframes_.clear();
  new_poses_.clear();
  new_run_ = run;
  has_mail_ = true;
  searched_ = 0;
  found_count_ = 0;
  mail_.notify_one();
}

void LoopSearch::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopped_ = true;
    mail_.notify_one();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

void LoopSearch::work() {
  std::vector<geometry::Pose2> poses;
  while (takeMail(poses)) {
    if (const std::size_t known = std::min(poses.size(), closer_.size()); searched_ < known) {
      // One at a time: newer poses, or the end, may have come meanwhile.
      search(static_cast<graph::NodeId>(searched_), poses);
    }
  }
}

bool LoopSearch::takeMail(std::vector<geometry::Pose2>& poses) {
  std::unique_lock<std::mutex> lock(mutex_);
  mail_.wait(lock, [&] {
    const bool has_work = searched_ < std::min(poses.size(), closer_.size());
    return is_stopped_ || has_mail_ || has_work;
  });
  if (run_ != new_run_) {
    run_ = new_run_;
    closer_.reset();
    poses.clear();
  }
  if (!new_poses_.empty()) {
    poses = std::move(new_poses_);
    new_poses_.clear();
  }
  for (; !new_keyframes_.empty(); new_keyframes_.pop_front()) {
    closer_.addKeyframe(std::move(new_keyframes_.front()));
  }
  has_mail_ = false;
  return !is_stopped_;
}

void LoopSearch::search(graph::NodeId id, const std::vector<geometry::Pose2>& poses) {
  const auto constraints = closer_.search(id, poses);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (run_ != new_run_) {
      return;  // the run ended while we searched
    }
    ++searched_;
    found_count_ += constraints.size();
  }
  found_(constraints, run_);
}

}  // namespace omega_slam
