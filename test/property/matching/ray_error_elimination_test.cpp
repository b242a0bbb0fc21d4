#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/hill_climbing_matcher.h"
#include "omega_slam/matching/particle_matcher.h"
#include "omega_slam/matching/ray_error.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/world_file.h"
#include "support/paths.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

constexpr int kPlaces = 4;  // for each seed

/// What a URG at rest measures.
/// @param noise share of the noise that the data sheet allows
View measure(const simulation::World& world, const Pose2& T_world_laser, double noise,
             std::uint64_t seed) {
  simulation::HokuyoConfig config;
  config.near_accuracy *= noise;
  config.far_accuracy *= noise;
  simulation::Hokuyo hokuyo(config, 0.0, seed);
  const auto scan = hokuyo.sweep(world, {0.0, T_world_laser}, {0.09, T_world_laser});
  View view;
  for (std::size_t i = 0; i < scan->ranges.size(); ++i) {
    if (std::isfinite(scan->ranges[i])) {
      const double angle = scan->angle_min + static_cast<double>(i) * scan->angle_increment;
      view.points.emplace_back(scan->ranges[i] * std::cos(angle),
                               scan->ranges[i] * std::sin(angle));
    }
  }
  return view;
}

/// A place where the robot fits and the laser sees enough.
Pose2 drawPlace(const simulation::World& world, std::mt19937_64& random) {
  const auto& geometry = world.geometry();
  std::uniform_real_distribution<double> x(0.0, geometry.width * geometry.resolution);
  std::uniform_real_distribution<double> y(0.0, geometry.height * geometry.resolution);
  std::uniform_real_distribution<double> heading(-geometry::kPi, geometry::kPi);
  Pose2 place;
  do {
    place = {geometry.origin.x() + x(random), geometry.origin.y() + y(random), heading(random)};
  } while (world.nearestObstacle(place.translation(), 0.25) ||
           measure(world, place, 0.0, 1).points.size() < 100);
  return place;
}

struct Candidate {
  std::string name;
  std::shared_ptr<const ScanMatcher> matcher;
};

std::ostream& operator<<(std::ostream& os, const Candidate& candidate) {
  return os << candidate.name;
}

class RayErrorElimination : public testing::TestWithParam<Candidate> {
 protected:
  /// 1 - sum of the errors after matching / before, of two scans from one place, the second one
  /// noisy, over many places.
  /// @param translation [m] by which the second is displaced, in a random direction
  /// @param rotation [rad] to a random side
  [[nodiscard]] double quotient(double translation, double rotation) const {
    const auto world =
        simulation::loadWorld(test::sourceFolder() / "maps" / "lab.world.yaml").world;
    double before = 0.0;
    double after = 0.0;
    for (const auto seed : test::seeds()) {
      std::mt19937_64 random(seed);
      for (int i = 0; i < kPlaces; ++i) {
        const Pose2 place = drawPlace(*world, random);
        const View reference = measure(*world, place, 0.0, 1);
        const View scan = measure(*world, place, 1.0, random());
        std::uniform_real_distribution<double> side(-geometry::kPi, geometry::kPi);
        const double direction = side(random);
        const Pose2 guess{translation * std::cos(direction), translation * std::sin(direction),
                          std::copysign(rotation, side(random))};
        const MatchResult result = GetParam().matcher->match({reference}, scan, guess);
        const RayReference error(Reference{reference});
        before += error.squaredError(RayScan(scan), guess);
        after += error.squaredError(RayScan(scan), result.T_reference_scan);
      }
    }
    return 1.0 - after / before;
  }
};

// The bounds lie below the worst of 60 runs with one seed each, which was one of the cartesian
// space.
TEST_P(RayErrorElimination, OfSmallDisplacements) { EXPECT_GT(quotient(0.1, 0.0), 0.95); }

TEST_P(RayErrorElimination, OfLargeDisplacements) { EXPECT_GT(quotient(1.0, 0.0), 0.8); }

TEST_P(RayErrorElimination, OfSmallRotations) { EXPECT_GT(quotient(0.0, 0.1), 0.8); }

TEST_P(RayErrorElimination, OfLargeRotations) { EXPECT_GT(quotient(0.0, 1.0), 0.8); }

Candidate particles(const std::string& space) {
  ParticleConfig config;
  config.space = space;
  return {space + "_particles", std::make_shared<ParticleMatcher>(config)};
}

INSTANTIATE_TEST_SUITE_P(Matchers, RayErrorElimination,
                         testing::Values(Candidate{"hill_climbing",
                                                   std::make_shared<HillClimbingMatcher>()},
                                         particles("odometry"), particles("cartesian")),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace omega_slam::matching
