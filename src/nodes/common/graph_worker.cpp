#include "nodes/common/graph_worker.h"

#include <fmt/format.h>

#include <utility>

namespace omega_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;

}  // namespace

GraphWorker::GraphWorker(const slam::BackEndConfig& config, Diagnostics& diagnostics,
                         Changed changed)
    : diagnostics_(diagnostics),
      changed_(std::move(changed)),
      back_end_(config),
      thread_(&GraphWorker::work, this) {}

GraphWorker::~GraphWorker() { stop(); }

void GraphWorker::add(KeyframeArrival keyframe) { post(keyframe); }

void GraphWorker::add(ConstraintArrival constraints) { post(std::move(constraints)); }

void GraphWorker::reset() { post(Reset{}); }

void GraphWorker::post(Mail mail) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mailbox_.push_back(std::move(mail));
  has_mail_.notify_one();
}

void GraphWorker::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopped_ = true;
    has_mail_.notify_one();
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

GraphSnapshotPtr GraphWorker::snapshot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return snapshot_;
}

void GraphWorker::work() {
  while (true) {
    std::vector<Mail> mail;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      has_mail_.wait(lock, [this] { return is_stopped_ || !mailbox_.empty(); });
      if (is_stopped_) {
        return;
      }
      std::swap(mail, mailbox_);
    }
    for (const Mail& letter : mail) {
      std::visit([this](const auto& content) { handle(content); }, letter);
    }
    if (grow()) {
      share(assembler_.run());
    }
  }
}

void GraphWorker::handle(const KeyframeArrival& keyframe) {
  switch (assembler_.add(keyframe)) {
    case GraphAssembler::Verdict::kTaken:
      diagnostics_.accept(keyframe.stamp.toSec());
      break;
    case GraphAssembler::Verdict::kKnown:
      break;
    case GraphAssembler::Verdict::kNewRun:
      ROS_INFO("Keyframe 0 of a new run: the graph begins anew.");
      back_end_.reset();
      diagnostics_.rearm();
      diagnostics_.accept(keyframe.stamp.toSec());
      break;
    case GraphAssembler::Verdict::kOtherRun:
      diagnostics_.reject("keyframe of another run",
                          fmt::format("Keyframe {} does not belong to the graph, and a new run "
                                      "begins with keyframe 0.",
                                      keyframe.id));
      break;
  }
}

void GraphWorker::handle(const ConstraintArrival& constraints) {
  if (assembler_.add(constraints) == GraphAssembler::Verdict::kOtherRun) {
    diagnostics_.reject("constraints of another run");
  }
}

void GraphWorker::handle(const Reset& /*reset*/) {
  const std::uint64_t ended = assembler_.run();
  assembler_.reset();
  back_end_.reset();
  diagnostics_.rearm();
  share(ended);
}

bool GraphWorker::grow() {
  const ros::SteadyTime begin = ros::SteadyTime::now();
  bool has_grown = false;
  while (const auto step = assembler_.next()) {
    const std::string refusal =
        step->keyframe ? back_end_.addKeyframe(step->keyframe->id, step->keyframe->T_odom_base,
                                               step->constraints)
                       : back_end_.addConstraints(step->constraints);
    if (!refusal.empty()) {
      diagnostics_.reject(refusal);
    }
    has_grown = true;
  }
  if (has_grown) {
    diagnostics_.set("last update [ms]", 1e3 * (ros::SteadyTime::now() - begin).toSec());
    reportHealth();
  }
  diagnostics_.set("keyframes waiting", static_cast<double>(assembler_.waiting()));
  return has_grown;
}

void GraphWorker::reportHealth() {
  const graph::SolveReport& report = back_end_.report();
  diagnostics_.set("last solve, iterations", report.iterations);
  diagnostics_.set("keyframes retired", static_cast<double>(back_end_.retired()));
  diagnostics_.set("loops withdrawn", static_cast<double>(back_end_.withdrawn().size()));
  if (report.status == graph::SolveStatus::kFailed) {
    diagnostics_.reject("solver failed", report.message);
    diagnostics_.setHealth(DiagnosticStatus::ERROR, "The solver failed: " + report.message);
  } else {
    diagnostics_.setHealth(DiagnosticStatus::OK, "growing");
  }
}

void GraphWorker::share(std::uint64_t run) {
  auto snapshot = std::make_shared<GraphSnapshot>();
  snapshot->run = run;
  snapshot->graph = back_end_.graph();
  snapshot->stamps = assembler_.stamps();
  snapshot->T_map_odom = back_end_.mapFromOdometry();
  snapshot->chi_square = graph::chiSquare(snapshot->graph);
  snapshot->beliefs = back_end_.beliefs();
  diagnostics_.set("keyframes", static_cast<double>(snapshot->graph.poses.size()));
  diagnostics_.set("constraints", static_cast<double>(snapshot->graph.constraints.size()));
  diagnostics_.set("chi-square", snapshot->chi_square);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshot_ = snapshot;
  }
  changed_(snapshot);
}

}  // namespace omega_slam
