#include "omega_slam/matching/hill_climbing_matcher.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/ray_landscape.h"
#include "omega_slam/matching/scan_motion.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kSmallestStep = 0.001;  // [m] of the distance; the others keep their ratio to it
// [rad] A quarter turn to each side: the distance may be negative.
constexpr double kDirectionReach = 0.5 * geometry::kPi;
constexpr int kLeastReach = 2;  // steps to each side
constexpr double kMostReach = 100.0;
constexpr int kClimb = 8;       // steps beyond the reach, at most
constexpr double kGain = 1e-3;  // share of the error; less is no improvement
constexpr int kVariables = 3;

/// A movement of the scan and its error.
struct Candidate {
  Eigen::Vector3d motion;
  double error;  // [m^2]
};

/// Walks from movement to better movement.
class Climber {
 public:
  Climber(const Reference& reference, const View& scan, const HillClimbingConfig& config)
      : config_(config),
        landscape_(reference, scan, config.error_cap),
        motion_(reference, scan),
        first_steps_(config.direction_step, config.distance_step, config.rotation_step),
        first_reach_(kDirectionReach, config.distance_reach, config.rotation_reach) {}

  [[nodiscard]] MatchResult climb(const Pose2& guess, const MatchConfig& common) {
    Candidate best{motion_.fromPose(guess), 0.0};
    best.error = errorOf(best.motion);
    int variable = mostPromising(best);
    int in_vain = 0;  // variables taken up without a gain, at the smallest steps
    const double smallest = std::min(kSmallestStep / config_.distance_step, 1.0);
    for (int i = 0; i < kVariables * config_.rounds && in_vain < kVariables; ++i) {
      if (landscape_.setStep(scale_ * config_.distance_step)) {
        best.error = errorOf(best.motion);
      }
      const Candidate next = climbAlong(variable, best);
      const bool gained = next.error < (1.0 - kGain) * best.error;
      in_vain = gained || scale_ > smallest ? 0 : in_vain + 1;
      best = gained ? next : best;
      scale_ = std::max(scale_ * config_.shrink, smallest);
      variable = (variable + kVariables - 1) % kVariables;
    }
    return landscape_.judge(motion_.toPose(best.motion), in_vain == kVariables, common);
  }

 private:
  [[nodiscard]] double errorOf(const Eigen::Vector3d& motion) const {
    return landscape_.error(motion_.toPose(motion));
  }

  /// @param steps of the present size along the variable
  [[nodiscard]] Candidate stepped(const Candidate& from, int variable, int steps) const {
    Eigen::Vector3d motion = from.motion;
    motion[variable] += steps * scale_ * first_steps_[variable];
    const double step = scale_ * config_.distance_step;
    if (variable == kDirection && std::abs(motion[kDistance]) < step) {
      motion[kDistance] = step;  // the direction of no movement is none
    }
    return {motion, errorOf(motion)};
  }

  /// The best of the steps to both sides; from the outermost, on as long as it gets better.
  [[nodiscard]] Candidate climbAlong(int variable, const Candidate& from) const {
    const double share = scale_ * first_reach_[variable] / first_steps_[variable];
    const int reach = std::max(static_cast<int>(std::min(share, kMostReach)), kLeastReach);
    Candidate best = from;
    int steps = 0;
    for (int i = 1; i <= reach; ++i) {
      for (const int side : {-i, i}) {
        const Candidate next = stepped(from, variable, side);
        if (next.error < best.error) {
          best = next;
          steps = side;
        }
      }
    }
    const int side = steps < 0 ? -1 : 1;
    for (int i = 1; i <= kClimb && std::abs(steps) >= reach; ++i) {
      const Candidate next = stepped(from, variable, steps + i * side);
      if (next.error >= best.error) {
        break;
      }
      best = next;
    }
    return best;
  }

  /// The variable that improves most.
  [[nodiscard]] int mostPromising(const Candidate& from) const {
    int promising = kRotation;
    double least = from.error;
    for (int variable = 0; variable < kVariables; ++variable) {
      const double error = climbAlong(variable, from).error;
      if (error < least) {
        least = error;
        promising = variable;
      }
    }
    return promising;
  }

  const HillClimbingConfig& config_;
  RayLandscape landscape_;
  ScanMotion motion_;
  Eigen::Vector3d first_steps_;
  Eigen::Vector3d first_reach_;
  double scale_{1.0};  // of the steps, now
};

}  // namespace

std::vector<std::string> HillClimbingConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("direction_step", direction_step, 0.0);
  violations.requireAbove("distance_step", distance_step, 0.0);
  violations.requireAbove("rotation_step", rotation_step, 0.0);
  violations.requireAtLeast("distance_reach", distance_reach, 0.0);
  violations.requireAtLeast("rotation_reach", rotation_reach, 0.0);
  violations.requireAbove("shrink", shrink, 0.0);
  violations.requireWithin("shrink", shrink, 0.0, 1.0);
  violations.requireWithin("rounds", rounds, 0, 1000);
  violations.requireAbove("error_cap", error_cap, 0.0);
  return violations.sentences();
}

HillClimbingMatcher::HillClimbingMatcher(const HillClimbingConfig& config,
                                         const MatchConfig& common)
    : config_(config), common_(common) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
}

MatchResult HillClimbingMatcher::match(const Reference& reference, const View& scan,
                                       const Pose2& guess) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return *refused;
  }
  return Climber(reference, scan, config_).climb(guess, common_);
}

}  // namespace omega_slam::matching
