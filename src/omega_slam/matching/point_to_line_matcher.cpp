#include "omega_slam/matching/point_to_line_matcher.h"

#include <algorithm>
#include <cmath>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/match_quality.h"
#include "omega_slam/matching/point_to_line.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kShrinkage = 0.7;           // of the reach, from step to step
constexpr double kTolerancePerReach = 0.33;  // a partner that far off counts half
constexpr double kSmallestTolerance = 2.0;   // in standard deviations of a range
constexpr double kCalming = 0.7;             // of the steps, where one takes back the last
constexpr std::size_t kFewPoints = 100;
constexpr double kRoughStep = 2e-3;     // [m], [rad] few points can't tell more
constexpr double kSmallestStep = 1e-3;  // [m], [rad] well below what a laser tells
/// By so much the confidence of a hundred points may fall short of what it comes to at the end. (Of
/// 3305 good matches in two recordings, one fell shorter.)
constexpr double kDoubtOfFew = 0.1;

/// The way from a guess to the pose of least cost.
class Descent {
 public:
  Descent(const PointToLineMatcherConfig& config, const MatchConfig& common,
          SurfaceModel& reference, const Pose2& guess)
      : config_(config), common_(common), reference_(reference), guess_(guess), pose_(guess) {}

  /// Steps while the reach shrinks to the outlier distance.
  void approach(const SomePoints& scan) {
    for (double reach = config_.max_correspondence_distance; reach > common_.outlier_distance;
         reach *= kShrinkage) {
      if (steps_ == config_.max_iterations) {
        return;
      }
      step(scan, reach);
    }
  }

  /// Steps until they are small. @return whether that was before the iterations ran out
  bool settle(const SomePoints& scan, double smallest_step) {
    while (steps_ < config_.max_iterations) {
      if (step(scan, common_.outlier_distance) < smallest_step) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] const Pose2& pose() const { return pose_; }

 private:
  /// @return its size: [m] or [rad], whichever is larger
  double step(const SomePoints& scan, double reach) {
    const double tolerance =
        std::max(kTolerancePerReach * reach, kSmallestTolerance * common_.range_noise);
    const auto equations =
        linearize(reference_, scan, pose_, {reach, common_.range_noise, tolerance});
    Eigen::Vector3d step = stepToLeastSquares(equations, pose_, guess_);
    if (step.dot(last_step_) < 0.0) {  // points that change partners to and fro might never rest
      gain_ *= kCalming;
    }
    step *= gain_;
    pose_ = Pose2::fromVector(pose_.vector() + step);
    last_step_ = step;
    ++steps_;
    return std::max(step.head<2>().norm(), std::abs(step[2]));
  }

  const PointToLineMatcherConfig& config_;
  const MatchConfig& common_;
  SurfaceModel& reference_;
  Pose2 guess_;
  Pose2 pose_;
  Eigen::Vector3d last_step_{Eigen::Vector3d::Zero()};
  double gain_{1.0};
  int steps_{0};
};

}  // namespace

std::vector<std::string> PointToLineMatcherConfig::validate() const {
  geometry::Violations violations;
  violations.requireAtLeast("max_iterations", max_iterations, 0);
  violations.requireAbove("max_correspondence_distance", max_correspondence_distance, 0.0);
  return violations.sentences();
}

PointToLineMatcher::PointToLineMatcher(const PointToLineMatcherConfig& config,
                                       const MatchConfig& common, double least_confidence)
    : config_(config), common_(common), least_confidence_(least_confidence) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
}

MatchResult PointToLineMatcher::match(const Reference& reference, const View& scan,
                                      const Pose2& guess) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return *refused;
  }
  SurfaceModel model(reference);
  Descent descent(config_, common_, model, guess);
  const SomePoints few = someOf(scan, kFewPoints);
  descent.approach(few);
  (void)descent.settle(few, kRoughStep);
  const double least = least_confidence_ - kDoubtOfFew;
  if (least > 0.0 && confidenceAt(model, few, descent.pose(), common_) < least) {
    return refusal(guess, MatchFailure::kNotConverged);
  }
  const bool converged = descent.settle({scan}, kSmallestStep);
  MatchResult result = judgeMatch(model, scan, descent.pose(), common_);
  result.converged = converged;
  if (!converged && result.failure == MatchFailure::kNone) {
    result.failure = MatchFailure::kNotConverged;
  }
  return result;
}

}  // namespace omega_slam::matching
