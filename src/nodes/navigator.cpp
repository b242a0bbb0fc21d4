#include "omega_slam/navigation/navigator.h"

#include <actionlib/server/simple_action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <omega_slam/PoseGraph.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "nodes/common/conversions.h"
#include "nodes/common/diagnostics.h"
#include "nodes/common/graph_motion.h"
#include "nodes/common/names.h"
#include "nodes/common/navigation_messages.h"
#include "nodes/common/navigator_config.h"
#include "nodes/common/node_config.h"
#include "nodes/common/node_runner.h"
#include "nodes/common/slam_conversions.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/navigation/sighting.h"
#include "omega_slam/sensing/sweep_duration.h"

namespace omega_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Stands where move_base stands: goals in, velocities out. All callbacks run in one thread, which
/// owns everything; a plan holds it up for some ten milliseconds.
class NavigatorNode {
 public:
  static constexpr unsigned kCallbackThreads = 1;
  using ActionServer = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;

  NavigatorNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh)
      : config_(loadConfig<NavigatorNodeConfig>(private_nh)),
        navigator_(config_.navigator, footprintOf(config_, nh)),
        intake_(config_.scans),
        tf_listener_(tf_buffer_),
        diagnostics_(nh, "navigator"),
        server_(nh, names::kMoveBase, false) {
    ROS_INFO_STREAM("The robot is driven as a disc of " << navigator_.radius() << " m.");
    command_publisher_ = nh.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    plan_publisher_ = nh.advertise<nav_msgs::Path>("plan", 1, true);
    local_plan_publisher_ = nh.advertise<nav_msgs::Path>("local_plan", 1);
    costmap_publisher_ = nh.advertise<nav_msgs::OccupancyGrid>("costmap", 1, true);
    const std::string action = names::kMoveBase;
    goal_publisher_ = nh.advertise<move_base_msgs::MoveBaseActionGoal>(action + "/goal", 1);
    subscribe(nh);
    plan_service_ = nh.advertiseService(action + "/make_plan", &NavigatorNode::onMakePlan, this);
    clear_service_ =
        nh.advertiseService(action + "/clear_costmaps", &NavigatorNode::onClearCostmaps, this);
    server_.registerGoalCallback([this] { onGoal(); });
    server_.registerPreemptCallback([this] { onPreempt(); });
    server_.start();
    timer_ = nh.createTimer(ros::Rate(config_.control_rate), &NavigatorNode::onTimer, this);
    costmap_timer_ = nh.createTimer(ros::Duration(std::max(0.1, config_.costmap_interval)),
                                    &NavigatorNode::onCostmapTimer, this);
  }

  void shutdown() {
    if (navigator_.hasGoal()) {
      command({});
    }
  }

 private:
  void subscribe(ros::NodeHandle& nh) {
    map_subscriber_ = nh.subscribe(names::kMap, 1, &NavigatorNode::onMap, this);
    scan_subscriber_ = nh.subscribe(names::kScan, 1, &NavigatorNode::onScan, this);
    odometry_subscriber_ = nh.subscribe(names::kOdometry, 1, &NavigatorNode::onOdometry, this);
    pose_graph_subscriber_ = nh.subscribe(names::kPoseGraph, 1, &NavigatorNode::onPoseGraph, this);
    bumper_subscriber_ = nh.subscribe(names::kBumper, 1, &NavigatorNode::onBumper, this);
    simple_goal_subscriber_ =
        nh.subscribe("move_base_simple/goal", 1, &NavigatorNode::onSimpleGoal, this);
  }

  void onMap(const nav_msgs::OccupancyGrid::ConstPtr& message) {
    const auto map = gridFromRos(*message);
    if (!map || map->geometry.size() == 0) {
      diagnostics_.reject("map is none");
    } else if (frameName(message->header.frame_id) != config_.map_frame) {
      diagnostics_.reject("map of another frame", "A map in frame '" + message->header.frame_id +
                                                      "' is of no use here: map_frame is '" +
                                                      config_.map_frame + "'.");
    } else {
      navigator_.setMap(*map);
    }
  }

  /// What was touched moves with the map; another run has another map.
  void onPoseGraph(const PoseGraph::ConstPtr& message) {
    auto poses = posesFromRos(*message);
    if (!poses.value) {
      diagnostics_.reject(poses.fault);
    } else if (const auto motion = graph_motion_.take(message->run, std::move(*poses.value))) {
      navigator_.moveMap(*motion);
    } else {
      navigator_.forgetObstacles();
    }
  }

  /// Scans wait until tf reaches to their end, but only the newest one.
  void onScan(const sensor_msgs::LaserScan::ConstPtr& message) {
    scan_ = message;
    serveScan();
  }

  void serveScan() {
    if (!scan_) {
      return;
    }
    const sensing::LaserScan scan = scanFromRos(*scan_);
    const double end = scan.stamp + sensing::sweepDuration(scan);
    const auto T_map_start = pose(timeToRos(scan.stamp));
    const auto T_map_end = pose(timeToRos(end));
    const auto mount = lookupLaserMount(tf_buffer_, config_.base_frame, scan_->header.frame_id,
                                        scan_->header.stamp);
    if (!T_map_start.value || !T_map_end.value || !mount.value) {
      return;  // where that lasts, step() says that there is no scan
    }
    const auto taken = intake_.process(
        scan, *mount.value, relativePose(T_map_start.value->pose, T_map_end.value->pose));
    scan_.reset();
    if (!taken.sweep) {
      diagnostics_.reject(taken.rejection);
      return;
    }
    diagnostics_.accept(scan.stamp);
    navigator_.see(navigation::sightingFrom(*taken.sweep),
                   T_map_start.value->pose * taken.T_start_sweep);
  }

  void onOdometry(const nav_msgs::Odometry::ConstPtr& message) {
    velocity_ = {message->twist.twist.linear.x, message->twist.twist.angular.z};
    velocity_stamp_ = message->header.stamp;
  }

  void onBumper(const sensor_msgs::PointCloud2::ConstPtr& message) {
    const auto contacts = contactsOf(*message, navigator_.radius(), config_.base_frame, tf_buffer_);
    if (contacts.value) {
      navigator_.touch(*contacts.value, ros::Time::now().toSec());
    } else {
      diagnostics_.reject("no place of the bumper on the robot", contacts.problem);
    }
  }

  void onSimpleGoal(const geometry_msgs::PoseStamped::ConstPtr& message) {
    move_base_msgs::MoveBaseActionGoal goal;
    goal.header.stamp = ros::Time::now();
    goal.goal.target_pose = *message;
    goal_publisher_.publish(goal);
  }

  /// A pose in the map, by tf as it is now.
  [[nodiscard]] TfAnswer<geometry::Pose2> inMap(const geometry_msgs::PoseStamped& stamped) const {
    const auto T_frame_pose = poseFromRos(stamped.pose);
    if (!T_frame_pose) {
      return {std::nullopt, "It is not a pose of finite numbers."};
    }
    if (frameName(stamped.header.frame_id) == config_.map_frame) {
      return {T_frame_pose, {}};
    }
    const auto T_map_frame =
        lookupPose(tf_buffer_, config_.map_frame, stamped.header.frame_id, ros::Time(0));
    if (!T_map_frame.value) {
      return {std::nullopt, T_map_frame.problem};
    }
    return {T_map_frame.value->pose * *T_frame_pose, {}};
  }

  [[nodiscard]] TfAnswer<geometry::StampedPose2> pose(const ros::Time& stamp) const {
    return lookupPose(tf_buffer_, config_.map_frame, config_.base_frame, stamp);
  }

  void onGoal() {
    const auto goal = server_.acceptNewGoal();
    const auto T_map_goal = inMap(goal->target_pose);
    if (!T_map_goal.value) {
      navigator_.cancel();
      command({});
      server_.setAborted({}, "The goal can't be used. " + T_map_goal.problem);
      return;
    }
    navigator_.setGoal({T_map_goal.value->translation(), T_map_goal.value->theta},
                       ros::Time::now().toSec());
    published_path_.clear();
  }

  void onPreempt() {
    if (server_.isNewGoalAvailable()) {
      return;  // onGoal() hands over without a stop
    }
    navigator_.cancel();
    command({});
    server_.setPreempted({}, "Somebody wanted it otherwise.");
  }

  void onTimer(const ros::TimerEvent&) {
    serveScan();
    const auto T_map_base = pose(ros::Time(0));
    const bool had_goal = navigator_.hasGoal();
    const ros::Time now = ros::Time::now();
    const bool fresh = std::abs((now - velocity_stamp_).toSec()) < config_.navigator.max_input_age;
    const auto step = navigator_.step(now.toSec(), T_map_base.value,
                                      fresh ? velocity_ : motion::Twist2{kNan, kNan});
    report(step, T_map_base.problem);
    if (!had_goal) {
      return;  // somebody else may drive
    }
    command(step.velocity);
    publishPaths(step, now);
    if (T_map_base.value) {
      move_base_msgs::MoveBaseFeedback feedback;
      feedback.base_position.header.frame_id = config_.map_frame;
      feedback.base_position.header.stamp = timeToRos(T_map_base.value->stamp);
      feedback.base_position.pose = poseToRos(T_map_base.value->pose);
      server_.publishFeedback(feedback);
    }
    if (step.state == navigation::NavigationState::kReached) {
      server_.setSucceeded({}, "The goal is reached.");
    } else if (step.state == navigation::NavigationState::kFailed) {
      ROS_WARN_STREAM("The goal is given up: " << step.reason);
      server_.setAborted({}, step.reason);
    }
  }

  void command(const motion::Twist2& velocity) {
    geometry_msgs::Twist message;
    message.linear.x = velocity.linear;
    message.angular.z = velocity.angular;
    command_publisher_.publish(message);
  }

  void publishPaths(const navigation::NavigatorStep& step, const ros::Time& now) {
    if (navigator_.path() != published_path_ && navigator_.goal()) {
      published_path_ = navigator_.path();
      plan_publisher_.publish(pathToRos(published_path_, navigator_.goal()->heading.value_or(0.0),
                                        config_.map_frame, now));
    }
    if (local_plan_publisher_.getNumSubscribers() > 0) {
      local_plan_publisher_.publish(posesToRos(step.rollout, config_.map_frame, now));
    }
  }

  void onCostmapTimer(const ros::TimerEvent&) {
    if (costmap_publisher_.getNumSubscribers() > 0 && navigator_.costmap().hasMap()) {
      costmap_publisher_.publish(costmapToRos(navigator_.costmap(), navigator_.planner().cost(),
                                              config_.map_frame, ros::Time::now()));
    }
  }

  void report(const navigation::NavigatorStep& step, const std::string& tf_problem) {
    using Status = diagnostic_msgs::DiagnosticStatus;
    static constexpr const char* kStates[] = {"idle",    "driving", "recovering",
                                              "waiting", "reached", "failed"};
    const std::string state = kStates[static_cast<std::size_t>(step.state)];
    diagnostics_.setHealth(step.reason.empty() ? Status::OK : Status::WARN,
                           step.reason.empty() ? state : state + ": " + step.reason);
    diagnostics_.set("recovery", navigation::nameOf(step.recovery));
    if (step.state == navigation::NavigationState::kWaiting) {
      ROS_WARN_STREAM_THROTTLE(5.0,
                               "The robot stands and waits. " << step.reason << ' ' << tf_problem);
    }
  }

  bool onMakePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response) {
    TfAnswer<geometry::Pose2> start;
    if (request.start.header.frame_id.empty()) {
      const auto here = pose(ros::Time(0));
      start = {here.value ? std::optional(here.value->pose) : std::nullopt, here.problem};
    } else {
      start = inMap(request.start);
    }
    const auto goal = inMap(request.goal);
    response.plan.header.frame_id = config_.map_frame;
    response.plan.header.stamp = ros::Time::now();
    if (!start.value || !goal.value) {
      ROS_WARN_STREAM("There is no plan. " << (start.value ? goal.problem : start.problem));
      return true;
    }
    const navigation::Plan plan =
        navigator_.plan(start.value->translation(), goal.value->translation(),
                        std::max(0.0, static_cast<double>(request.tolerance)));
    if (!plan.found()) {
      ROS_WARN_STREAM("There is no plan. " << plan.reason);
      return true;
    }
    response.plan = pathToRos(plan.path, goal.value->theta, config_.map_frame, ros::Time::now());
    return true;
  }

  bool onClearCostmaps(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
    navigator_.forgetObstacles();
    return true;
  }

  const NavigatorNodeConfig config_;
  navigation::Navigator navigator_;
  sensing::ScanIntake intake_;
  sensor_msgs::LaserScan::ConstPtr scan_;  ///< waits for tf
  motion::Twist2 velocity_{kNan, kNan};
  ros::Time velocity_stamp_;
  GraphMotion graph_motion_;
  navigation::Path published_path_;
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_;
  Diagnostics diagnostics_;
  ActionServer server_;
  ros::Publisher command_publisher_;
  ros::Publisher plan_publisher_;
  ros::Publisher local_plan_publisher_;
  ros::Publisher costmap_publisher_;
  ros::Publisher goal_publisher_;
  ros::Subscriber map_subscriber_;
  ros::Subscriber scan_subscriber_;
  ros::Subscriber odometry_subscriber_;
  ros::Subscriber pose_graph_subscriber_;
  ros::Subscriber bumper_subscriber_;
  ros::Subscriber simple_goal_subscriber_;
  ros::ServiceServer plan_service_;
  ros::ServiceServer clear_service_;
  ros::Timer timer_;
  ros::Timer costmap_timer_;
};

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  return omega_slam::runNode<omega_slam::NavigatorNode>(argc, argv, "navigator");
}
