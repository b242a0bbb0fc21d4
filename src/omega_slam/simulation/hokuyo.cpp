#include "omega_slam/simulation/hokuyo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::simulation {
namespace {

/// A draw outside of the bounds is repeated so often at most; with bounds of one deviation or more
/// the limit is reached less than once in 10^15 beams.
constexpr int kMaxDraws = 32;

}  // namespace

std::vector<std::string> HokuyoConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("rate", rate, 0.0);
  violations.requireAtLeast("beams", beams, 1.0);
  violations.requireAbove("angle_increment", angle_increment, 0.0);
  violations.requireWithin("beams * angle_increment", std::max(beams, 0) * angle_increment, 0.0,
                           2.0 * geometry::kPi);
  violations.requireAtLeast("range_min", range_min, 0.0);
  violations.requireAbove("range_max", range_max, range_min);
  violations.requireAtLeast("dark_range", dark_range, 0.0);
  violations.requireAtLeast("near_accuracy", near_accuracy, 0.0);
  violations.requireAtLeast("near_limit", near_limit, 0.0);
  violations.requireAtLeast("far_accuracy", far_accuracy, 0.0);
  violations.requireAtLeast("accuracy_in_deviations", accuracy_in_deviations, 1.0);
  return violations.sentences();
}

Hokuyo::Hokuyo(const HokuyoConfig& config, double start, std::uint64_t seed)
    : config_(config), start_(start), random_(seed) {
  geometry::throwIfAny(config_.validate());
  beginScan();
}

std::optional<sensing::LaserScan> Hokuyo::sweep(const Surroundings& surroundings,
                                                const geometry::StampedPose2& from,
                                                const geometry::StampedPose2& to) {
  std::optional<sensing::LaserScan> finished;
  while (true) {
    const auto beam = static_cast<double>(scan_.ranges.size());
    const double stamp = scan_.stamp + beam * scan_.time_increment;
    if (stamp >= to.stamp) {
      return finished;
    }
    const double share = (stamp - from.stamp) / (to.stamp - from.stamp);
    const geometry::Pose2 T_world_laser = geometry::interpolate(from.pose, to.pose, share);
    scan_.ranges.push_back(
        measure(surroundings, T_world_laser, scan_.angle_min + beam * scan_.angle_increment));
    if (scan_.ranges.size() == static_cast<std::size_t>(config_.beams)) {
      finished = std::move(scan_);
      beginScan();
    }
  }
}

void Hokuyo::beginScan() {
  scan_ = {};
  scan_.stamp = start_ + static_cast<double>(scans_) / config_.rate;
  scan_.angle_min = -0.5 * (config_.beams - 1) * config_.angle_increment;
  scan_.angle_increment = config_.angle_increment;
  scan_.time_increment = config_.angle_increment / (2.0 * geometry::kPi * config_.rate);
  scan_.range_min = config_.range_min;
  scan_.range_max = config_.range_max;
  scan_.ranges.reserve(static_cast<std::size_t>(config_.beams));
  ++scans_;
}

float Hokuyo::measure(const Surroundings& surroundings, const geometry::Pose2& T_world_laser,
                      double angle) {
  const float no_return = config_.no_return_is_inf ? std::numeric_limits<float>::infinity()
                                                   : std::numeric_limits<float>::quiet_NaN();
  const auto hit = surroundings.castRay(T_world_laser.translation(), T_world_laser.theta + angle,
                                        config_.range_max);
  if (!hit || (hit->material == Material::kDark && hit->range > config_.dark_range)) {
    return no_return;
  }
  const double range = hit->range + error(hit->range);
  return range < config_.range_min || range > config_.range_max ? no_return
                                                                : static_cast<float>(range);
}

double Hokuyo::error(double range) {
  const double bound =
      range < config_.near_limit ? config_.near_accuracy : config_.far_accuracy * range;
  double deviations = normal_(random_);
  for (int draw = 1; draw < kMaxDraws && std::abs(deviations) > config_.accuracy_in_deviations;
       ++draw) {
    deviations = normal_(random_);
  }
  const double limited =
      std::clamp(deviations, -config_.accuracy_in_deviations, config_.accuracy_in_deviations);
  return bound * limited / config_.accuracy_in_deviations;
}

}  // namespace omega_slam::simulation
