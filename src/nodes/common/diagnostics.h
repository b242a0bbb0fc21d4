#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace omega_slam {

/// Keeps account of what a node takes in, mends and refuses, and publishes it on /diagnostics once
/// a second of wall time (so that it goes on while simulated time stands still). Three statuses:
///   "<node>: input"   how much came in, how often, how late;
///   "<node>: faults"  repairs and rejections, counted by cause;
///   "<node>: health"  what the node itself says of its work.
/// A cause is a short stable phrase. Each is logged as a warning the first time, then only counted.
/// Thread-safe.
class Diagnostics {
 public:
  /// @param node how the statuses name the node
  Diagnostics(ros::NodeHandle nh, std::string node);
  /// Keeps account without publishing: there need be no master.
  explicit Diagnostics(std::string node);

  /// One more input was used. @param stamp [s] its time, for the latency
  void accept(double stamp);
  /// An input was used after mending it. @param sentence logged with the cause; may be empty
  void repair(const std::string& cause, const std::string& sentence = {});
  /// An input was refused. @param sentence logged with the cause; may be empty
  void reject(const std::string& cause, const std::string& sentence = {});

  /// A fact shown under "health".
  void set(const std::string& key, const std::string& value);
  void set(const std::string& key, double value);
  /// The headline of "health". @param level one of diagnostic_msgs::DiagnosticStatus's
  void setHealth(std::int8_t level, const std::string& message);

  /// Causes are logged anew when they come again; the counts stand.
  void rearm();

  /// What is published; public for tests. @param seconds [s] since the last report
  [[nodiscard]] diagnostic_msgs::DiagnosticArray report(double seconds);

 private:
  using Counts = std::map<std::string, std::uint64_t>;
  void count(Counts& counts, const std::string& what, const std::string& cause,
             const std::string& sentence);
  [[nodiscard]] diagnostic_msgs::DiagnosticStatus inputStatus(double seconds) const;
  [[nodiscard]] diagnostic_msgs::DiagnosticStatus faultStatus() const;
  [[nodiscard]] diagnostic_msgs::DiagnosticStatus healthStatus() const;
  void publish(const ros::WallTimerEvent& event);

  std::string node_;
  mutable std::mutex mutex_;  ///< guards all below up to the publisher
  std::uint64_t accepted_{0};
  std::uint64_t accepted_before_{0};  ///< at the last report
  std::uint64_t faults_{0};
  std::uint64_t faults_before_{0};
  double latency_{0.0};  ///< [s] greatest since the last report
  Counts repairs_;
  Counts rejections_;
  std::set<std::string> logged_;
  std::map<std::string, std::string> facts_;
  std::int8_t level_{diagnostic_msgs::DiagnosticStatus::OK};
  std::string message_{"nothing to say yet"};
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace omega_slam
