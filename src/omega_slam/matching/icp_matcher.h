#pragma once

#include <string>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct IcpMatcherConfig {
  int max_iterations{50};
  double max_correspondence_distance{0.5};  ///< [m] first pass: how far off the guess may be

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Iterative Closest Point (Besl and McKay 1992), the implementation of PCL: a wide pass, then a
/// narrow one in which partners farther apart than the outlier distance are none.
class IcpMatcher : public ScanMatcher {
 public:
  /// @throws std::invalid_argument
  explicit IcpMatcher(const IcpMatcherConfig& config = {}, const MatchConfig& common = {});
  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

 private:
  IcpMatcherConfig config_;
  MatchConfig common_;
};

}  // namespace omega_slam::matching
