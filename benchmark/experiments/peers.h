#pragma once

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::experiments {

/// PCL's ICP as it comes: point to point in the plane, partners up to 0.5 m apart, up to 50
/// iterations or until a step is below 0.1 mm. The unit of time of all comparisons; building the
/// kd-tree is part of it.
///
/// Like the other peer it says nothing of its confidence, but for whether it converged, and claims
/// no covariance. Only for views of the laser's plane; clouds as PCL wants them are made on the
/// way, which costs a few microseconds.
class PclIcp : public matching::ScanMatcher {
 public:
  [[nodiscard]] matching::MatchResult match(const matching::Reference& reference,
                                            const matching::View& scan,
                                            const geometry::Pose2& guess) const override;
};

/// PCL's Normal Distributions Transform (Magnusson 2009), with cells of 1 m, steps of up to 5 cm
/// and 35 iterations, on flat clouds. Of cells of 0.5, 1 and 2 m and steps from 0.05 to 0.3 these
/// did best; PCL's class for the plane, after Biber and Strasser, did worse with all of its
/// settings.
class PclNdt : public matching::ScanMatcher {
 public:
  [[nodiscard]] matching::MatchResult match(const matching::Reference& reference,
                                            const matching::View& scan,
                                            const geometry::Pose2& guess) const override;
};

}  // namespace omega_slam::experiments
