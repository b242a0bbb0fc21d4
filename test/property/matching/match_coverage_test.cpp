// Whether matchers are as good as they say: their errors against their own covariance, on simulated
// scans of the TurtleBot's laser.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/correlative_matcher.h"
#include "omega_slam/matching/hill_climbing_matcher.h"
#include "omega_slam/matching/icp_matcher.h"
#include "omega_slam/matching/map_matcher.h"
#include "omega_slam/matching/particle_matcher.h"
#include "omega_slam/matching/point_to_line_matcher.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/world_file.h"
#include "support/paths.h"
#include "support/poses.h"
#include "support/seeds.h"

namespace omega_slam::matching {
namespace {

using geometry::Pose2;

/// Two scans of a robot that stands still for each.
struct Pair {
  View reference;
  View scan;
  Pose2 T_reference_scan;
};

View look(const simulation::World& world, const Pose2& place, std::mt19937_64& random) {
  simulation::HokuyoConfig config;
  config.rate = 1.0;
  simulation::Hokuyo laser(config, 0.0, random());
  const auto scan = laser.sweep(world, {0.0, place}, {0.999, place});
  View view;
  for (std::size_t i = 0; scan && i < scan->ranges.size(); ++i) {
    if (scan->ranges[i] <= scan->range_max) {
      const double angle = scan->angle_min + static_cast<double>(i) * scan->angle_increment;
      view.points.emplace_back(scan->ranges[i] * std::cos(angle),
                               scan->ranges[i] * std::sin(angle));
    }
  }
  return view;
}

/// Two places 0.1 to 0.5 m apart on a world's route, looking anywhere.
Pair lookTwice(const simulation::LoadedWorld& world, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto& route = world.file.route;
  Eigen::Vector2d leg(0.0, 0.0);
  Eigen::Vector2d start(0.0, 0.0);
  while (leg.norm() < 0.6) {
    const std::size_t i = random() % (route.size() - 1);
    start = route[i];
    leg = route[i + 1] - start;
  }
  const Eigen::Vector2d direction = leg.normalized();
  const Eigen::Vector2d first = start + (leg.norm() - 0.5) * share(random) * direction;
  const Eigen::Vector2d second = first + (0.1 + 0.4 * share(random)) * direction;
  const Pose2 from{first.x(), first.y(), geometry::kPi * (2.0 * share(random) - 1.0)};
  const double turn = share(random) - 0.5;
  const Pose2 to{second.x(), second.y(), geometry::normalizeAngle(from.theta + turn)};
  return {look(*world.world, from, random), look(*world.world, to, random), relativePose(from, to)};
}

struct Tally {
  int matches{0};
  int trusted{0};
  int converged{0};
  int outside{0};  // of the bound of three deviations
  double squares{0.0};

  void add(const MatchResult& match, const Pose2& truth) {
    ++matches;
    converged += match.converged ? 1 : 0;
    if (match.confidence < 0.5 || match.failure != MatchFailure::kNone) {
      return;
    }
    Eigen::Vector3d error = match.T_reference_scan.vector() - truth.vector();
    error[2] = relativePose(truth, match.T_reference_scan).theta;
    const double squared = error.dot(match.covariance.inverse() * error);
    ++trusted;
    outside += squared > 14.16 ? 1 : 0;  // of three degrees of freedom 99.73 % are below
    squares += std::min(squared, 50.0);
  }
};

Tally matchPairs(const ScanMatcher& matcher, int pairs_per_seed) {
  Tally tally;
  for (const std::string world_name : {"lab", "office"}) {
    const auto world =
        simulation::loadWorld(test::sourceFolder() / "maps" / (world_name + ".world.yaml"));
    for (const auto seed : test::seeds()) {
      std::mt19937_64 random(seed);
      for (int i = 0; i < pairs_per_seed; ++i) {
        const Pair pair = lookTwice(world, random);
        const Pose2 guess = Pose2::fromVector(pair.T_reference_scan.vector() +
                                              test::randomPose(0.1, 0.087, random).vector());
        tally.add(matcher.match({pair.reference}, pair.scan, guess), pair.T_reference_scan);
      }
    }
  }
  return tally;
}

void expectHonest(const Tally& tally, int percent_converged = 98) {
  EXPECT_GE(tally.trusted, 9 * tally.matches / 10);
  EXPECT_GE(tally.converged, percent_converged * tally.matches / 100);
  EXPECT_LE(tally.outside, 1 + 3 * tally.trusted / 100);
  EXPECT_GT(tally.squares / tally.trusted, 0.2) << "absurdly wide";
  EXPECT_LT(tally.squares / tally.trusted, 5.0);
}

/// With 40 seeds, 5 of 1574 trusted matches were outside, and the squares had a mean of 0.86.
TEST(MatchCoverage, PointToLine) { expectHonest(matchPairs(PointToLineMatcher(), 20)); }

/// With 40 seeds, 9 of 1543 trusted matches were outside, and the squares had a mean of 0.81.
TEST(MatchCoverage, ScanToMap) { expectHonest(matchPairs(MapMatcher(), 20)); }

TEST(MatchCoverage, Correlative) { expectHonest(matchPairs(CorrelativeMatcher(), 10)); }

/// With 40 seeds, 3 of 471 trusted matches were outside, and the squares had a mean of 0.99.
TEST(MatchCoverage, Icp) { expectHonest(matchPairs(IcpMatcher(), 6)); }

/// With 40 seeds, 4 of 1571 trusted matches were outside, and the squares had a mean of 1.29.
TEST(MatchCoverage, HillClimbing) { expectHonest(matchPairs(HillClimbingMatcher(), 20)); }

/// With 40 seeds, 2 of 760 trusted matches were outside, the squares had a mean of 1.08, and 96 %
/// of all converged.
TEST(MatchCoverage, Particles) { expectHonest(matchPairs(ParticleMatcher(), 10), 92); }

}  // namespace
}  // namespace omega_slam::matching
