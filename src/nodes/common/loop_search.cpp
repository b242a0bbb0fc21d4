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
  new_keyframes_.push_back(std::move(keyframe));  // of no use without the graph: nobody is woken
}

void LoopSearch::setGraph(graph::PoseGraph graph) {
  const std::lock_guard<std::mutex> lock(mutex_);
  new_graph_ = std::move(graph);
  has_mail_ = true;
  mail_.notify_one();
}

void LoopSearch::reset(std::uint64_t run) {
  const std::lock_guard<std::mutex> lock(mutex_);
  new_keyframes_.clear();
  new_graph_ = {};
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
  graph::PoseGraph graph;
  while (takeMail(graph)) {
    if (const std::size_t known = std::min(graph.poses.size(), closer_.size()); searched_ < known) {
      // One at a time: a newer graph, or the end, may have come meanwhile.
      search(static_cast<graph::NodeId>(searched_), graph);
    }
  }
}

bool LoopSearch::takeMail(graph::PoseGraph& graph) {
  std::unique_lock<std::mutex> lock(mutex_);
  mail_.wait(lock, [&] {
    const bool has_work = searched_ < std::min(graph.poses.size(), closer_.size());
    return is_stopped_ || has_mail_ || has_work;
  });
  if (run_ != new_run_) {
    run_ = new_run_;
    closer_.reset();
    graph = {};
  }
  if (!new_graph_.poses.empty()) {
    graph = std::exchange(new_graph_, {});
  }
  for (; !new_keyframes_.empty(); new_keyframes_.pop_front()) {
    closer_.addKeyframe(std::move(new_keyframes_.front()));
  }
  has_mail_ = false;
  return !is_stopped_;
}

void LoopSearch::search(graph::NodeId id, const graph::PoseGraph& graph) {
  const auto constraints = closer_.search(id, graph);
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
