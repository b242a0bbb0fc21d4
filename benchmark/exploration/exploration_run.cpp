#include "exploration/exploration_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exploration/map_in_step.h"
#include "exploration/thread_timer.h"
#include "omega_slam/config/slam_config.h"
#include "omega_slam/evaluation/rigid_fit.h"
#include "omega_slam/motion/odometry_buffer.h"
#include "omega_slam/navigation/navigator.h"
#include "omega_slam/navigation/sighting.h"
#include "omega_slam/simulation/turtlebot.h"

namespace omega_slam::experiments {
namespace {

using exploration::Order;
using exploration::Phase;
using geometry::Pose2;

constexpr double kDriveInterval = 0.1;    // [s] between commands
constexpr double kExploreInterval = 0.2;  // [s] between looks at what has happened
constexpr double kSampleInterval = 2.0;   // [s]

/// Everything that is alive during a run.
class Run {
 public:
  explicit Run(const RunSetup& setup)
      : setup_(setup),
        robot_config_(robotConfig(setup)),
        robot_(setup.world, setup.T_world_start, robot_config_),
        localisation_(makeLocalisation(setup.localisation, config_)),
        intake_(config_.scan_matcher.intake),
        map_(config_.map_builder.mapper),
        explorer_(setup.explorer),
        navigator_({}, setup.footprint) {
    odometry_.add(robot_.time(), {});
    truth_.add(robot_.time(), setup.T_world_start);
    (void)explorer_.start();
  }

  RunOutcome run() {
    const double start = robot_.time();
    while (explorer_.phase() != Phase::kEnded && robot_.time() - start < setup_.patience) {
      step();
    }
    sample();
    outcome_.ended = explorer_.phase() == Phase::kEnded;
    outcome_.ending = explorer_.ending();
    outcome_.reason = explorer_.reason();
    outcome_.end = outcome_.samples.back();
    outcome_.from_home = distance(robot_.truth().T_world_base, setup_.T_world_start);
    outcome_.map = map_.render();
    return std::move(outcome_);
  }

 private:
  static simulation::TurtleBotConfig robotConfig(const RunSetup& setup) {
    simulation::TurtleBotConfig config;
    config.seed = setup.seed;
    config.hokuyo.no_return_is_inf = true;  // as REP-117 has it: open space is seen to be open
    return config;
  }

  void step() {
    const simulation::TurtleBotEvents events = robot_.step();
    odometry_.add(events.odometry.stamp, events.odometry.T_odom_base);
    truth_.add(events.truth.stamp, events.truth.T_world_base);
    velocity_ = events.odometry.velocity;
    bumper_ = events.bumper.value_or(bumper_);
    trackTruth(events.truth.T_world_base);
    while (static_cast<int>(outcome_.contacts.size()) < robot_.collisions()) {
      outcome_.contacts.push_back({robot_.time() - robot_config_.start_time,
                                   events.truth.T_world_base,
                                   touchesUnseen(events.truth.T_world_base.translation())});
    }
    if (events.scan) {
      takeScan(*events.scan);
    }
    if (isDue(next_map_, config_.map_builder.update_interval)) {
      drawMap();
    }
    if (isDue(next_look_, kExploreInterval)) {
      const ThreadTimer timer(outcome_.explorer_cpu);
      obey(explorer_.update(robot_.time(), pose()));
    }
    if (isDue(next_drive_, kDriveInterval)) {
      drive();
    }
    if (isDue(next_sample_, kSampleInterval)) {
      sample();
    }
  }

  bool isDue(double& next, double interval) const {
    if (robot_.time() < next) {
      return false;
    }
    next = robot_.time() + interval - 1e-9;
    return true;
  }

  void trackTruth(const Pose2& T_world_base) {
    if (outcome_.path.empty()) {
      outcome_.path.push_back(T_world_base.translation());
    }
    const double step = (T_world_base.translation() - outcome_.path.back()).norm();
    if (step > 0.05) {
      outcome_.path.push_back(T_world_base.translation());
      driven_ += step;
    }
  }

  /// Whether what the robot touches is no plain wall.
  [[nodiscard]] bool touchesUnseen(const Eigen::Vector2d& position) const {
    const grid::GridGeometry& geometry = setup_.world->geometry();
    const auto contact =
        setup_.world->nearestObstacle(position, robot_config_.kobuki.radius + 0.05);
    if (!contact) {
      return false;
    }
    const Eigen::Vector2d inside = *contact + 0.01 * (*contact - position).normalized();
    const simulation::Material material = setup_.world->at(geometry.cellAt(inside));
    return material == simulation::Material::kGlass || material == simulation::Material::kDark;
  }

  void takeScan(const sensing::LaserScan& scan) {
    const Pose2 T_odom_base = odometry_.at(scan.stamp).value();
    const double last_beam =
        scan.stamp + scan.time_increment * static_cast<double>(scan.ranges.size() - 1);
    const Pose2 during =
        relativePose(T_odom_base, odometry_.at(std::min(last_beam, robot_.time())).value());
    const sensing::LaserMount mount{robot_config_.T_base_laser, false};
    const Pose2 T_world_base = truth_.at(scan.stamp).value();
    localisation_->take({&scan, mount, T_odom_base, during, T_world_base});
    if (localisation_->poses().size() > graph_poses_.size()) {  // solved with each keyframe
      navigator_.moveMap({graph_poses_, localisation_->poses()});
      graph_poses_ = localisation_->poses();
    }
    if (const auto& keyframes = localisation_->keyframes(); keyframes.size() > true_poses_.size()) {
      true_poses_.push_back(truth_.at(keyframes.back()->sweep.stamp).value());
    }
    const auto taken = intake_.process(scan, mount, during);
    if (const auto T_map_odom = localisation_->mapFromOdom(); taken.sweep && T_map_odom) {
      const ThreadTimer timer(outcome_.navigator_cpu);
      navigator_.see(navigation::sightingFrom(*taken.sweep),
                     *T_map_odom * T_odom_base * taken.T_start_sweep);
    }
  }

  [[nodiscard]] std::optional<Pose2> pose() const {
    const auto T_map_odom = localisation_->mapFromOdom();
    if (!T_map_odom) {
      return std::nullopt;
    }
    return *T_map_odom * odometry_.at(robot_.time()).value();
  }

  void drawMap() {
    const MapInStep::Change change = map_.update(*localisation_);
    if (!change.is_new) {
      return;
    }
    newest_map_ = std::make_shared<const grid::OccupancyGrid>(map_.render());
    {
      const ThreadTimer timer(outcome_.navigator_cpu);
      navigator_.setMap(*newest_map_);
    }
    const ThreadTimer timer(outcome_.explorer_cpu);
    explorer_.showMap(newest_map_, change.news, change.motion ? &*change.motion : nullptr);
  }

  void obey(const Order& order) {
    if (order.kind == Order::Kind::kCancel) {
      navigator_.cancel();
      goal_.reset();
    } else if (order.kind == Order::Kind::kGo) {
      goal_ = order.goal.id;
      const auto frontier = explorer_.frontiers().find(order.goal.frontier);
      outcome_.goals.push_back(
          {robot_.time() - robot_config_.start_time, order.goal.T_map_base,
           frontier == explorer_.frontiers().end() ? 0.0 : frontier->second.size, "dropped"});
      navigator_.setGoal({order.goal.T_map_base.translation(), order.goal.T_map_base.theta},
                         robot_.time());
    }
    if (explorer_.phase() == Phase::kReturning && outcome_.explored_time == 0.0) {
      outcome_.explored_time = robot_.time() - robot_config_.start_time;
      outcome_.explored_distance = driven_;
    }
  }

  /// Where kobuki's bumpers are, in the base frame [m].
  [[nodiscard]] std::vector<Eigen::Vector2d> contactsOf(const simulation::Bumper& bumper) const {
    constexpr double kSide = 0.9;  // [rad] from the middle to a side switch
    std::vector<Eigen::Vector2d> contacts;
    const auto add = [&](bool pressed, double angle) {
      if (pressed) {
        contacts.push_back(robot_config_.kobuki.radius *
                           Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      }
    };
    add(bumper.left, kSide);
    add(bumper.centre, 0.0);
    add(bumper.right, -kSide);
    return contacts;
  }

  void drive() {
    const ThreadTimer timer(outcome_.navigator_cpu);
    if (bumper_.any()) {
      navigator_.touch(contactsOf(bumper_), robot_.time());
      explorer_.touch(contactsOf(bumper_));
    }
    const auto T_map_base = pose();
    const auto step = navigator_.step(
        robot_.time(),
        T_map_base ? std::optional<geometry::StampedPose2>({robot_.time(), *T_map_base})
                   : std::nullopt,
        velocity_);
    (void)robot_.command(step.velocity);
    timeOf(step) += kDriveInterval;
    const bool reached = step.state == navigation::NavigationState::kReached;
    if (goal_ && (reached || step.state == navigation::NavigationState::kFailed)) {
      outcome_.goals.back().fate = reached ? "reached" : step.reason;
      explorer_.goalEnded(*goal_, reached);
      goal_.reset();
    }
  }

  /// What the time until the next command is spent on.
  double& timeOf(const navigation::NavigatorStep& step) {
    constexpr double kTurns = 0.1;    // [m/s] slower ones turn on the spot, if they do, by
    constexpr double kTurning = 0.2;  // [rad/s]
    if (step.state == navigation::NavigationState::kRecovering) {
      return outcome_.times.recovering;
    }
    if (std::abs(velocity_.linear) < kTurns && std::abs(velocity_.angular) > kTurning) {
      return outcome_.times.turning;
    }
    return step.state == navigation::NavigationState::kDriving ? outcome_.times.driving
                                                               : outcome_.times.standing;
  }

  /// Where the map lies in the world: as its keyframes do, and not as the first of them alone,
  /// whose heading moves what is far from it.
  [[nodiscard]] Pose2 placeOfMap() const {
    const std::vector<Pose2>& poses = localisation_->poses();
    std::vector<evaluation::PointPair> pairs;
    for (std::size_t k = 0; k < true_poses_.size(); ++k) {
      pairs.push_back({poses[k].translation(), true_poses_[k].translation()});
    }
    return evaluation::fitRigidMotion(pairs, true_poses_.front().theta - poses.front().theta);
  }

  void sample() {
    const double coverage = newest_map_ && setup_.seeable != nullptr
                                ? setup_.seeable->knownShare(*newest_map_, placeOfMap())
                                : 0.0;
    outcome_.samples.push_back({robot_.time() - robot_config_.start_time, driven_, coverage});
  }

  const RunSetup& setup_;
  const config::SlamConfig config_;
  const simulation::TurtleBotConfig robot_config_;
  simulation::TurtleBot robot_;
  const std::unique_ptr<Localisation> localisation_;
  sensing::ScanIntake intake_;
  MapInStep map_;
  exploration::Explorer explorer_;
  navigation::Navigator navigator_;
  motion::OdometryBuffer odometry_{2.0};
  motion::OdometryBuffer truth_{2.0};
  motion::Twist2 velocity_;
  simulation::Bumper bumper_;
  std::vector<Pose2> graph_poses_;
  std::vector<Pose2> true_poses_;  ///< `T_world_base` of each keyframe
  std::shared_ptr<const grid::OccupancyGrid> newest_map_;
  std::optional<std::uint64_t> goal_;
  double driven_{0.0};
  double next_map_{0.0};
  double next_look_{0.0};
  double next_drive_{0.0};
  double next_sample_{0.0};
  RunOutcome outcome_;
};

}  // namespace

RunOutcome explore(const RunSetup& setup) { return Run(setup).run(); }

}  // namespace omega_slam::experiments
