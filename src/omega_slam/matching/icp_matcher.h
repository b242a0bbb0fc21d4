#pragma once

#include <string>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

struct IcpMatcherConfig {
  int max_iterations{50};
  double max_correspondence_distance{0.5};  ///< [m] first pass: how far off the guess may be
  double outlier_distance{0.1};             ///< [m] second pass: farther partners are outliers
  int min_returns{30};                      ///< scans with fewer returns are refused
  double range_noise{0.02};  ///< [m] standard deviation of a range, scales the covariance

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Iterative Closest Point (Besl and McKay 1992), the implementation of PCL: a wide pass, then a
/// narrow one.
class IcpMatcher : public ScanMatcher {
 public:
  explicit IcpMatcher(const IcpMatcherConfig& config = {});  ///< @throws std::invalid_argument
  [[nodiscard]] MatchResult match(const Points& reference, const Points& scan,
                                  const geometry::Pose2& guess) const override;

 private:
  IcpMatcherConfig config_;
};

}  // namespace omega_slam::matching
