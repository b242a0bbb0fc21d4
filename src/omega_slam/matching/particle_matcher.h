#pragma once

#include <string>
#include <vector>

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

/// Where particles may live: "cartesian" is x, y and rotation; "odometry" direction of movement,
/// distance and rotation.
[[nodiscard]] std::vector<std::string> particleSpaces();

struct ParticleConfig {
  int particles{80};
  int rounds{20};                     ///< of resampling, at most
  double translation_deviation{0.5};  ///< [m] of the first particles around the guess
  double rotation_deviation{0.5};     ///< [rad]
  double shrink{0.7};                 ///< of the deviations, from round to round
  std::string space{"odometry"};      ///< one of particleSpaces()
  int seed{1};                        ///< of the particles
  double near_range{0.1};             ///< [m] returns from nearer than this are near ones
  double max_near_share{0.3};         ///< [0, 1] scans with more near returns are refused
  double error_cap{0.3};              ///< [m] of a ray's error, see RayReference

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Particle sampling as in the paper (section 6.4): a population of poses, scored by the squared
/// error of their rays, is resampled in proportion to its fitness; new particles are drawn from a
/// normal distribution around the ones picked, whose deviation shrinks from round to round.
/// docs/algorithms/matching/particle_sampling.md tells the details.
///
/// Converged means that all particles have come together. The same call gives the same result.
class ParticleMatcher : public ScanMatcher {
 public:
  /// @throws std::invalid_argument
  explicit ParticleMatcher(const ParticleConfig& config = {}, const MatchConfig& common = {});
  [[nodiscard]] MatchResult match(const Reference& reference, const View& scan,
                                  const geometry::Pose2& guess) const override;

 private:
  ParticleConfig config_;
  MatchConfig common_;
};

}  // namespace omega_slam::matching
