#include "experiments/scan_trial.h"

#include <cmath>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr std::uint32_t kPlaceStream = 1;

}  // namespace

std::vector<Pose2> drawPlaces(const Arena& arena, std::size_t count, std::uint32_t seed) {
  std::vector<Pose2> places;
  for (std::uint32_t k = 0; k < count; ++k) {
    auto random = generatorFor({seed, kPlaceStream, k});
    places.push_back(drawFreePose(arena, random));
  }
  return places;
}

Pose2 drawOdometry(OdometryNoise noise, double level, std::mt19937_64& random) {
  std::uniform_real_distribution<double> heading(-geometry::kPi, geometry::kPi);
  const double direction = heading(random);
  if (noise == OdometryNoise::kTranslation) {
    return {level * std::cos(direction), level * std::sin(direction), 0.0};
  }
  return {0.0, 0.0, geometry::normalizeAngle(direction < 0.0 ? -level : level)};
}

TwoScans takeTwoScans(const Arena& arena, const Pose2& T_world_base, std::mt19937_64& random) {
  TwoScans scans;
  scans.reference = takeScan(arena, T_world_base, random);
  scans.scan = takeScan(arena, T_world_base, random);
  return scans;
}

}  // namespace omega_slam::experiments
