#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"

namespace omega_slam::matching {

using Points = std::vector<Eigen::Vector2d>;

/// What a laser saw from one place.
struct View {
  Points points;                     ///< [m] where its beams hit something, in the sweep's order
  Eigen::Vector2d origin{0.0, 0.0};  ///< [m] where the laser stood, in the frame of the points
};

/// What a scan is matched with: views of the surroundings, all in one frame, the newest last.
using Reference = std::vector<View>;

/// All points of a reference, view by view.
[[nodiscard]] Points allPoints(const Reference& reference);

/// The same view seen from another frame: `p_a = T_a_b * p_b`.
[[nodiscard]] View transformed(const geometry::Pose2& T_a_b, const View& view_b);

/// Why a match is not to be trusted.
enum class MatchFailure {
  kNone,
  kTooFewReturns,  ///< of the scan or of the reference
  kTooManyNear,    ///< of the scan's returns: something covers the laser
  kNoOverlap,      ///< no point of the scan lies near one of the reference
  kDegenerate,     ///< a direction is open: see MatchResult::open_direction
  kNotConverged    ///< before the iterations ran out
};

[[nodiscard]] std::string toString(MatchFailure failure);

/// What a matcher found. Everything is finite, whatever went in.
struct MatchResult {
  geometry::Pose2 T_reference_scan;  ///< the guess where the matcher failed before it began
  /// Covariance of (x, y, theta) of `T_reference_scan`, in the reference's frame for the
  /// translation [m^2, m rad, rad^2]. Large in a direction that the scans do not determine.
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Identity()};
  /// [0, 1]; the caller applies the result only above a threshold of its own.
  double confidence{0.0};
  double overlap{0.0};   ///< [0, 1] share of the scan's points that found a partner
  double residual{0.0};  ///< [m] root mean square distance of the partners
  bool converged{false};
  MatchFailure failure{MatchFailure::kNone};
  /// The direction that the scans do not determine, where there is one: a unit vector along
  /// (x, y, theta * 1 m) in the reference's frame. (1, 0, 0) in a corridor along x, (0, 0, 1) in
  /// the middle of a round room.
  std::optional<Eigen::Vector3d> open_direction;
};

/// The answer of a matcher that did not get to work: the guess, or the identity where even that is
/// not finite, at no confidence.
[[nodiscard]] MatchResult refusal(const geometry::Pose2& guess, MatchFailure failure);

/// What all matchers share.
struct MatchConfig {
  int min_returns{30};           ///< scans and references with fewer points are refused
  double outlier_distance{0.1};  ///< [m] a point whose partner is farther away has none
  double range_noise{0.02};      ///< [m] standard deviation of a range

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Whether a match can be tried at all: the refusal if not.
[[nodiscard]] std::optional<MatchResult> refuseHopeless(const Reference& reference,
                                                        const View& scan,
                                                        const geometry::Pose2& guess,
                                                        const MatchConfig& config);

/// Finds the pose of a scan in the frame of a reference. Deterministic: the same call gives the
/// same result, whatever was matched before.
class ScanMatcher {
 public:
  virtual ~ScanMatcher() = default;

  /// @param reference in the reference's frame
  /// @param scan      in the scan's frame
  /// @param guess     `T_reference_scan` to begin with
  [[nodiscard]] virtual MatchResult match(const Reference& reference, const View& scan,
                                          const geometry::Pose2& guess) const = 0;
};

}  // namespace omega_slam::matching
