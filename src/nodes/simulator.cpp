#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/transform_broadcaster.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/names.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/simulator_config.h"
#include "nodes/common/simulator_messages.h"
#include "nodes/common/simulator_pacer.h"
#include "omega_slam/simulation/turtlebot.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam {
namespace {

constexpr double kPatience = 0.25;       // [s] of wall time
constexpr double kReportInterval = 1.0;  // [s] of wall time
constexpr double kClockInterval = 0.1;   // [s] of wall time, while the clock stands
constexpr unsigned kClockQueue = 100;

double wallNow() { return ros::SteadyTime::now().toSec(); }

simulation::TurtleBot makeRobot(const SimulatorConfig& config) {
  const simulation::LoadedWorld loaded = simulation::loadWorld(config.world);
  ROS_INFO_STREAM("World '" << config.world << "': " << loaded.file.description);
  return simulation::TurtleBot(loaded.world, loaded.file.start, config.robot);
}

/// A TurtleBot that only exists in here: lets time pass, and says what the real one says.
///
/// One thread of its own steps the robot and publishes; callbacks run in the spinner's thread and
/// share nothing with it but the robot, under a mutex.
class SimulatorNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;

  SimulatorNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<SimulatorConfig>(private_nh)),
        robot_(makeRobot(config_)),
        pacer_(config_.speed, kPatience),
        diagnostics_(nh, "simulator") {
    clock_publisher_ = nh.advertise<rosgraph_msgs::Clock>("/clock", kClockQueue);
    odometry_publisher_ = nh.advertise<nav_msgs::Odometry>(names::kOdometry, names::kOdometryQueue);
    joints_publisher_ =
        nh.advertise<sensor_msgs::JointState>("joint_states", names::kOdometryQueue);
    scan_publisher_ = nh.advertise<sensor_msgs::LaserScan>(names::kScan, names::kScanQueue);
    bumper_publisher_ = nh.advertise<sensor_msgs::PointCloud2>(names::kBumper, names::kScanQueue);
    truth_publisher_ = nh.advertise<nav_msgs::Odometry>(names::kGroundTruth, names::kOdometryQueue);
    command_subscriber_ =
        nh.subscribe("mobile_base/commands/velocity", 1, &SimulatorNode::onCommand, this,
                     ros::TransportHints().tcpNoDelay());
    reset_odometry_subscriber_ = nh.subscribe("mobile_base/commands/reset_odometry", 1,
                                              &SimulatorNode::onResetOdometry, this);
    reset_service_ = nh.advertiseService("reset_positions", &SimulatorNode::onResetPositions, this);
    diagnostics_.setHealth(diagnostic_msgs::DiagnosticStatus::OK, "about to start");
    thread_ = std::thread(&SimulatorNode::run, this);
  }

  ~SimulatorNode() { shutdown(); }

  void shutdown() {
    {
      const std::lock_guard<std::mutex> lock(stop_mutex_);
      stop_ = true;
    }
    stop_signal_.notify_all();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

 private:
  void onCommand(const geometry_msgs::Twist::ConstPtr& message) {
    const std::lock_guard<std::mutex> lock(robot_mutex_);
    if (robot_.command({message->linear.x, message->angular.z})) {
      diagnostics_.accept(robot_.time());
    } else {
      diagnostics_.reject("velocity command is not finite");
    }
  }

  void onResetOdometry(const std_msgs::Empty::ConstPtr&) {
    const std::lock_guard<std::mutex> lock(robot_mutex_);
    robot_.resetOdometry();
    ROS_INFO("The odometry is set to zero.");
  }

  bool onResetPositions(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
    const std::lock_guard<std::mutex> lock(robot_mutex_);
    robot_.resetPosition();
    ROS_INFO("The robot is carried back to its start; its odometry does not know.");
    return true;
  }

  void run() {
    for (double waited = 0.0; waited < config_.start_delay; waited += kClockInterval) {
      publishClock(config_.robot.start_time);
      if (stopsWithin(kClockInterval)) {
        return;
      }
    }
    publishStart();
    pacer_.start(wallNow(), config_.robot.start_time);
    double next_report = wallNow() + kReportInterval;
    while (true) {
      const double simulated = step();
      const double wall = wallNow();
      if (wall >= next_report) {
        report(wall, simulated);
        next_report = wall + kReportInterval;
      }
      if (stopsWithin(pacer_.wait(wall, simulated))) {
        return;
      }
    }
  }

  void publishStart() {
    const std::lock_guard<std::mutex> lock(robot_mutex_);
    publish(robot_.now(), robot_.bumper());
  }

  /// @return true as soon as the node is to stop
  bool stopsWithin(double seconds) {
    std::unique_lock<std::mutex> lock(stop_mutex_);
    return stop_signal_.wait_for(lock, std::chrono::duration<double>(seconds),
                                 [this] { return stop_; });
  }

  /// @return [s] simulated time after the step
  double step() {
    simulation::TurtleBotEvents events;
    simulation::Bumper bumper;
    {
      const std::lock_guard<std::mutex> lock(robot_mutex_);
      events = robot_.step();
      bumper = robot_.bumper();
    }
    publish(events, bumper);
    return events.odometry.stamp;
  }

  void publish(const simulation::TurtleBotEvents& events, const simulation::Bumper& bumper) {
    // The clock goes first, so that nothing comes from its receiver's future.
    publishClock(events.odometry.stamp);
    tf_broadcaster_.sendTransform(
        odometryTransform(events.odometry, config_.odom_frame, config_.base_frame));
    odometry_publisher_.publish(
        odometryToRos(events.odometry, config_.odom_frame, config_.base_frame));
    joints_publisher_.publish(jointStatesToRos(events.odometry));
    truth_publisher_.publish(
        groundTruthToRos(events.truth, config_.world_frame, config_.base_frame));
    if (events.scan) {
      scan_publisher_.publish(laserScanToRos(*events.scan, config_.laser_frame));
    }
    // All the time while pressed, and once more when it is let go.
    if (bumper.any() || events.bumper) {
      bumper_publisher_.publish(
          bumperToRos(bumper, timeToRos(events.truth.stamp), config_.bumper_frame));
    }
  }

  void publishClock(double simulated) {
    rosgraph_msgs::Clock clock;
    clock.clock = timeToRos(simulated);
    clock_publisher_.publish(clock);
  }

  void report(double wall, double simulated) {
    const double speed = pacer_.measuredSpeed(wall, simulated);
    const bool lagged = pacer_.lostTime() > reported_lost_time_;
    reported_lost_time_ = pacer_.lostTime();
    if (lagged) {
      ROS_WARN_STREAM_THROTTLE(10.0, "The simulation cannot keep up: it runs at "
                                         << speed << " times real time instead of " << config_.speed
                                         << ".");
    }
    diagnostics_.set("simulated time [s]", simulated);
    diagnostics_.set("simulated seconds in a real one", speed);
    {
      const std::lock_guard<std::mutex> lock(robot_mutex_);
      diagnostics_.set("collisions", static_cast<double>(robot_.collisions()));
    }
    diagnostics_.setHealth(
        lagged ? diagnostic_msgs::DiagnosticStatus::WARN : diagnostic_msgs::DiagnosticStatus::OK,
        lagged ? "slower than asked for" : "running");
  }

  const SimulatorConfig config_;
  std::mutex robot_mutex_;  ///< guards the robot
  simulation::TurtleBot robot_;
  SimulatorPacer pacer_;
  double reported_lost_time_{0.0};
  Diagnostics diagnostics_;
  tf2_ros::TransformBroadcaster tf_broadcaster_;
  ros::Publisher clock_publisher_;
  ros::Publisher odometry_publisher_;
  ros::Publisher joints_publisher_;
  ros::Publisher scan_publisher_;
  ros::Publisher bumper_publisher_;
  ros::Publisher truth_publisher_;
  ros::Subscriber command_subscriber_;
  ros::Subscriber reset_odometry_subscriber_;
  ros::ServiceServer reset_service_;
  std::mutex stop_mutex_;  ///< guards the wish to stop
  std::condition_variable stop_signal_;
  bool stop_{false};
  std::thread thread_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::SimulatorNode>(argc, argv, "simulator");
}
