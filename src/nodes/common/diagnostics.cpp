#include "nodes/common/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "nodes/common/names.h"

namespace omega_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kPeriod = 1.0;  // [s] of wall time between two reports

diagnostic_msgs::KeyValue keyValue(const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = value;
  return pair;
}

DiagnosticStatus makeStatus(const std::string& name, std::int8_t level,
                            const std::string& message) {
  DiagnosticStatus status;
  status.name = name;
  status.hardware_id = "none";
  status.level = level;
  status.message = message;
  return status;
}

std::uint64_t total(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const auto& [cause, count] : counts) {
    sum += count;
  }
  return sum;
}

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle nh, std::string node)
    : node_(std::move(node)),
      publisher_(nh.advertise<diagnostic_msgs::DiagnosticArray>(names::kDiagnostics, 10)),
      timer_(nh.createWallTimer(ros::WallDuration(kPeriod), &Diagnostics::publish, this)) {}

Diagnostics::Diagnostics(std::string node) : node_(std::move(node)) {}

void Diagnostics::accept(double stamp) {
  const double latency = ros::Time::now().toSec() - stamp;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++accepted_;
  latency_ = std::max(latency_, latency);
}

void Diagnostics::repair(const std::string& cause, const std::string& sentence) {
  count(repairs_, "Repaired", cause, sentence);
}

void Diagnostics::reject(const std::string& cause, const std::string& sentence) {
  count(rejections_, "Rejected", cause, sentence);
}

void Diagnostics::count(Counts& counts, const std::string& what, const std::string& cause,
                        const std::string& sentence) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts[cause];
  ++faults_;
  if (!logged_.insert(what + cause).second) {
    return;
  }
  ROS_WARN_STREAM(what << ": " << cause << ". " << sentence << (sentence.empty() ? "" : " ")
                       << "Further cases are counted on " << names::kDiagnostics << ".");
}

void Diagnostics::set(const std::string& key, const std::string& value) {
  const std::lock_guard<std::mutex> lock(mutex_);
  facts_[key] = value;
}

void Diagnostics::set(const std::string& key, double value) {
  set(key, fmt::format("{:g}", value));
}

void Diagnostics::setHealth(std::int8_t level, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  level_ = level;
  message_ = message;
}

void Diagnostics::rearm() {
  const std::lock_guard<std::mutex> lock(mutex_);
  logged_.clear();
}

diagnostic_msgs::DiagnosticArray Diagnostics::report(double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status = {inputStatus(seconds), faultStatus(), healthStatus()};
  accepted_before_ = accepted_;
  faults_before_ = faults_;
  latency_ = 0.0;
  return array;
}

DiagnosticStatus Diagnostics::inputStatus(double seconds) const {
  const std::uint64_t fresh = accepted_ - accepted_before_;
  const double rate = seconds > 0.0 ? static_cast<double>(fresh) / seconds : 0.0;
  auto status = makeStatus(
      node_ + ": input", DiagnosticStatus::OK,
      accepted_ == 0 ? "no usable input yet" : fmt::format("{:.1f} inputs a second", rate));
  status.values = {keyValue("accepted", std::to_string(accepted_)),
                   keyValue("rate [Hz]", fmt::format("{:.2f}", rate)),
                   keyValue("latency [s]", fmt::format("{:.3f}", latency_))};
  return status;
}

DiagnosticStatus Diagnostics::faultStatus() const {
  // A fault of long ago stays in the counts, but is no reason to go on warning.
  const bool is_new = faults_ > faults_before_;
  auto status =
      makeStatus(node_ + ": faults", is_new ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 fmt::format("{} rejected, {} repaired", total(rejections_), total(repairs_)));
  for (const auto& [cause, count] : rejections_) {
    status.values.push_back(keyValue("rejected: " + cause, std::to_string(count)));
  }
  for (const auto& [cause, count] : repairs_) {
    status.values.push_back(keyValue("repaired: " + cause, std::to_string(count)));
  }
  return status;
}

DiagnosticStatus Diagnostics::healthStatus() const {
  auto status = makeStatus(node_ + ": health", level_, message_);
  for (const auto& [key, value] : facts_) {
    status.values.push_back(keyValue(key, value));
  }
  return status;
}

void Diagnostics::publish(const ros::WallTimerEvent& event) {
  const ros::WallDuration since = event.current_real - event.last_real;
  publisher_.publish(report(event.last_real.isZero() ? kPeriod : since.toSec()));
}

}  // namespace omega_slam
