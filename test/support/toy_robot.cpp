#include "support/toy_robot.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/exploration/own_place.h"
#include "omega_slam/exploration/travel_field.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::test {
namespace {

using exploration::Order;
using geometry::Pose2;

constexpr double kRange = 4.0;   // [m] of its laser
constexpr double kRadius = 0.2;  // [m] of its body

}  // namespace

sensing::Sweep sweepIn(const simulation::World& world, const Pose2& T_world_base, double range) {
  constexpr int kBeams = 481;
  sensing::Sweep sweep;
  sweep.angle_increment = 4.0 / 3.0 * geometry::kPi / (kBeams - 1);
  for (int i = 0; i < kBeams; ++i) {
    const double angle = (i - kBeams / 2) * sweep.angle_increment;
    const auto hit = world.castRay(T_world_base.translation(), T_world_base.theta + angle, range);
    // Into the wall by a hair, so that the end lies within its cell.
    const double reach = hit ? hit->range + 1e-6 : range;
    sweep.beams.push_back({reach * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                           hit ? sensing::BeamKind::kReturn : sensing::BeamKind::kNoReturn});
  }
  return sweep;
}

ToyRobot::ToyRobot(std::shared_ptr<const simulation::World> world, const Pose2& start)
    : world_(std::move(world)), pose_(start) {}

void ToyRobot::look(exploration::Explorer& explorer) {
  const sensing::Sweep sweep = sweepIn(*world_, pose_, kRange);
  (void)mapper_.add(sweep, pose_);
  map_ = std::make_shared<grid::OccupancyGrid>(mapper_.render());
  explorer.showMap(map_, {{&sweep, pose_}});
}

void ToyRobot::refuseGoalsNear(const Eigen::Vector2d& place, double radius) {
  refused_ = place;
  refused_radius_ = radius;
}

void ToyRobot::obey(const Order& order) {
  if (order.kind != Order::Kind::kKeepOn) {
    orders_.push_back(order);
  }
  if (order.kind == Order::Kind::kGo) {
    goal_ = order.goal;
  } else if (order.kind == Order::Kind::kCancel) {
    goal_.reset();
  }
}

void ToyRobot::drive(exploration::Explorer& explorer) {
  const auto map = exploration::withOwnPlaceFree(*map_, pose_.translation(), kRadius);
  const exploration::MapView view(map);
  const exploration::StandingRoom room(view, kRadius);
  const exploration::TravelField travel(room, pose_.translation(), 0.3);
  const Eigen::Vector2d target = goal_->T_map_base.translation();
  const auto path = travel.pathTo(view.cellAt(target));
  if (path.empty() || (target - refused_).norm() <= refused_radius_) {
    explorer.goalEnded(goal_->id, false);
    goal_.reset();
    return;
  }
  const std::size_t ahead = std::min<std::size_t>(6, path.size() - 1);
  const Eigen::Vector2d way = path[ahead] - pose_.translation();
  const double heading = way.norm() > 0.01 ? std::atan2(way.y(), way.x()) : pose_.theta;
  pose_ = {path[ahead].x(), path[ahead].y(), heading};
  if (ahead + 1 == path.size()) {
    pose_.theta = goal_->T_map_base.theta;
    explorer.goalEnded(goal_->id, true);
    goal_.reset();
  }
}

void ToyRobot::tick(exploration::Explorer& explorer) {
  now_ += 0.5;
  obey(explorer.update(now_, pose_));
  if (goal_) {
    drive(explorer);
    look(explorer);
  }
}

bool ToyRobot::run(exploration::Explorer& explorer, int max_ticks) {
  for (int i = 0; i < max_ticks && explorer.phase() != exploration::Phase::kEnded; ++i) {
    tick(explorer);
  }
  return explorer.phase() == exploration::Phase::kEnded;
}

}  // namespace omega_slam::test
