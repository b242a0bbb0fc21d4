#pragma once

#include <ros/node_handle.h>

#include <future>
#include <string>

namespace omega_slam {

/// Has map and graph saved by those who own them, in a thread of its own, because both may take
/// their time. Its own calls are for one thread.
class RunSaver {
 public:
  /// @param folder that is written to; empty: nothing is ever saved
  RunSaver(const ros::NodeHandle& nh, std::string folder);
  ~RunSaver() { finish(); }
  RunSaver(const RunSaver&) = delete;
  RunSaver& operator=(const RunSaver&) = delete;

  void save();    ///< begins; what came of it, poll() or finish() logs
  void poll();    ///< to be called now and then
  void finish();  ///< waits for what has begun

 private:
  void report();

  ros::NodeHandle nh_;
  std::string folder_;
  std::future<std::string> saving_;
};

}  // namespace omega_slam
