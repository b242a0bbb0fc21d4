#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/simulator_config.h"
#include "omega_slam/simulation/route_driver.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam {
namespace {

std::vector<Eigen::Vector2d> routeOf(const std::string& world) {
  std::vector<Eigen::Vector2d> route = simulation::readWorldFile(world).route;
  if (route.empty()) {
    throw std::runtime_error("World file '" + world + "' has no route to follow.");
  }
  return route;
}

/// Drives the simulated robot along its world's route, by the pose that only a simulator knows.
/// All callbacks run in one thread, which owns everything here.
class RouteFollowerNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  RouteFollowerNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<RouteFollowerConfig>(private_nh)),
        driver_(config_.driver, routeOf(config_.world)),
        diagnostics_(nh, "route_follower") {
    command_publisher_ = nh.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    status_publisher_ = nh.advertise<std_msgs::String>("route_status", 1, true);
    publishStatus();
    truth_subscriber_ = nh.subscribe(names::kGroundTruth, 1, &RouteFollowerNode::onTruth, this,
                                     ros::TransportHints().tcpNoDelay());
  }

  void shutdown() {}

 private:
  void onTruth(const nav_msgs::Odometry::ConstPtr& message) {
    const auto T_world_base = poseFromRos(message->pose.pose);
    if (!T_world_base) {
      diagnostics_.reject("true pose is not a finite pose");
      return;
    }
    diagnostics_.accept(message->header.stamp.toSec());
    if (driver_.status().state != simulation::RouteStatus::State::kDriving) {
      return;  // it has been told to stop; from here on somebody else may drive
    }
    const simulation::Twist2 command = driver_.update(message->header.stamp.toSec(), *T_world_base);
    geometry_msgs::Twist twist;
    twist.linear.x = command.linear;
    twist.angular.z = command.angular;
    command_publisher_.publish(twist);
    publishStatus();
  }

  void publishStatus() {
    const simulation::RouteStatus status = driver_.status();
    std_msgs::String message;
    message.data = status.toString();
    if (message.data == published_status_) {
      return;
    }
    published_status_ = message.data;
    status_publisher_.publish(message);
    const bool stuck = status.state == simulation::RouteStatus::State::kStuck;
    diagnostics_.setHealth(
        stuck ? diagnostic_msgs::DiagnosticStatus::ERROR : diagnostic_msgs::DiagnosticStatus::OK,
        message.data);
    if (stuck) {
      ROS_ERROR_STREAM("The route follower is " << message.data << ".");
    } else if (status.state == simulation::RouteStatus::State::kDone) {
      ROS_INFO("The route is done.");
    }
  }

  const RouteFollowerConfig config_;
  simulation::RouteDriver driver_;
  std::string published_status_;
  Diagnostics diagnostics_;
  ros::Publisher command_publisher_;
  ros::Publisher status_publisher_;
  ros::Subscriber truth_subscriber_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::RouteFollowerNode>(argc, argv, "route_follower");
}
