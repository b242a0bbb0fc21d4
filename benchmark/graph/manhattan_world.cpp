#include "graph/manhattan_world.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/first_guess.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using graph::NodeId;

namespace {

constexpr NodeId kShortestLoop = 10;  // steps: what is nearer, the odometry knows
constexpr double kTurnShare = 0.3;    // of the crossings

using Crossing = std::pair<int, int>;

class Driver {
 public:
  Driver(int side, std::mt19937_64& random)
      : side_(side), crossing_(side / 2, side / 2), random_(random) {}

  [[nodiscard]] const Crossing& crossing() const { return crossing_; }
  [[nodiscard]] Pose2 pose() const {
    return {static_cast<double>(crossing_.first), static_cast<double>(crossing_.second),
            geometry::normalizeAngle(0.5 * geometry::kPi * heading_)};
  }

  /// To the next crossing, then maybe round the corner.
  void drive() {
    crossing_ = ahead(heading_);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const int side = share(random_) < 0.5 ? 1 : 3;
    if (share(random_) < kTurnShare || !isInTown(ahead(heading_))) {
      heading_ = (heading_ + side) % 4;
    }
    if (!isInTown(ahead(heading_))) {
      heading_ = (heading_ + 2) % 4;  // a corner of the town, or the wrong way out of its rim
    }
  }

 private:
  [[nodiscard]] Crossing ahead(int heading) const {
    constexpr int kX[] = {1, 0, -1, 0};
    constexpr int kY[] = {0, 1, 0, -1};
    return {crossing_.first + kX[heading], crossing_.second + kY[heading]};
  }
  [[nodiscard]] bool isInTown(const Crossing& crossing) const {
    return std::min(crossing.first, crossing.second) >= 0 &&
           std::max(crossing.first, crossing.second) < side_;
  }

  int side_;
  Crossing crossing_;
  int heading_{0};  // quarter turns
  std::mt19937_64& random_;
};

class Meter {
 public:
  Meter(const ManhattanConfig& config, std::mt19937_64& random)
      : translation_(0.0, config.translation_deviation),
        rotation_(0.0, config.rotation_deviation),
        random_(random) {
    const double translation = std::pow(config.translation_deviation, -2.0);
    const double rotation = std::pow(config.rotation_deviation, -2.0);
    information_ = Eigen::Vector3d(translation, translation, rotation).asDiagonal();
  }

  [[nodiscard]] graph::Constraint measure(const std::vector<Pose2>& truth, NodeId from, NodeId to) {
    graph::Constraint constraint;
    constraint.from = from;
    constraint.to = to;
    const Pose2 error{translation_(random_), translation_(random_), rotation_(random_)};
    constraint.T_from_to = truth[from].inverse() * truth[to] * error;
    constraint.information = information_;
    constraint.kind =
        to - from == 1 ? graph::ConstraintKind::kOdometry : graph::ConstraintKind::kLoop;
    return constraint;
  }

 private:
  std::normal_distribution<double> translation_;
  std::normal_distribution<double> rotation_;
  std::mt19937_64& random_;
  Eigen::Matrix3d information_;
};

}  // namespace

ManhattanWorld driveManhattan(const ManhattanConfig& config) {
  std::mt19937_64 random(config.seed);
  const double crossings = static_cast<double>(config.poses) / config.visits;
  Driver driver(std::max(2, static_cast<int>(std::lround(std::sqrt(crossings)))), random);
  Meter meter(config, random);
  ManhattanWorld world;
  std::map<Crossing, NodeId> last_visits;
  int returns = 0;
  for (NodeId node = 0; node < config.poses; ++node) {
    world.truth.push_back(driver.pose());
    if (node > 0) {
      world.graph.constraints.push_back(meter.measure(world.truth, node - 1, node));
    }
    const auto visit = last_visits.find(driver.crossing());
    const bool is_back = visit != last_visits.end() && node - visit->second >= kShortestLoop;
    if (is_back && ++returns % config.returns_a_loop == 0) {
      world.graph.constraints.push_back(meter.measure(world.truth, visit->second, node));
    }
    last_visits[driver.crossing()] = node;
    driver.drive();
  }
  world.graph.poses = world.truth;
  graph::applyGuess(world.graph, graph::FirstGuess::kOdometry);
  return world;
}

}  // namespace omega_slam::experiments
