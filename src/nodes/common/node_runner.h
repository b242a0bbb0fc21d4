#pragma once

#include <ros/ros.h>

#include <exception>
#include <iostream>
#include <sstream>
#include <string>

namespace omega_slam {

/// Logs each line of a text, one fault a line, as fatal; on stderr where ROS, and its log with it,
/// is down already.
inline void logFatalLines(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (ros::ok()) {
      ROS_FATAL_STREAM(line);
    } else {
      std::cerr << "[FATAL] " << line << '\n';
    }
  }
}

/// The whole life of a node: connect, construct, serve until SIGINT, shut down. A class Node has
///   Node(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh), which throws
///       config::ConfigurationError (or std::invalid_argument) for parameters that can't be used;
///   static constexpr unsigned kCallbackThreads, in which its callbacks are served;
///   void shutdown(), called after the last callback has returned: ends workers, saves if asked to.
///
/// @return the process's exit code: 0 after SIGINT, 1 where the node could not start. A node that
/// can't start says why, one sentence a fault.
template <class Node>
int runNode(int argc, char** argv, const std::string& name) {
  ros::init(argc, argv, name);
  // With the last handle goes the logging; this one stays for what there may be to say.
  const ros::NodeHandle nh;
  try {
    Node node(nh, ros::NodeHandle("~"));
    ros::AsyncSpinner spinner(Node::kCallbackThreads);
    spinner.start();
    ros::waitForShutdown();
    spinner.stop();
    node.shutdown();
    return 0;
  } catch (const std::exception& error) {
    logFatalLines(error.what());
    return 1;
  }
}

}  // namespace omega_slam
