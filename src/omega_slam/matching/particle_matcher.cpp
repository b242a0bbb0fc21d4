#include "omega_slam/matching/particle_matcher.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/matching/ray_landscape.h"
#include "omega_slam/matching/scan_motion.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

const char* const kCartesian = "cartesian";
const char* const kOdometry = "odometry";

constexpr double kSharpness = 4.0;    // of the fitness: power of the inverse error
constexpr double kLeastError = 1e-6;  // [m^2]
constexpr double kTogether = 0.01;    // [m], [rad] deviation of particles that have come together

/// Where the particles live: vectors of three numbers that stand for poses of the scan.
struct Space {
  Eigen::Vector3d guess;
  Eigen::Vector3d deviations;  // of the first particles
  std::function<Pose2(const Eigen::Vector3d&)> toPose;
};

/// (x, y, rotation) of the scan's laser, seen from where it is by the guess.
Space cartesianSpace(const View& scan, const Pose2& guess, const ParticleConfig& config) {
  const Pose2 T_scan_laser{scan.origin.x(), scan.origin.y(), 0.0};
  return {Eigen::Vector3d::Zero(),
          {config.translation_deviation, config.translation_deviation, config.rotation_deviation},
          [T_reference_laser = guess * T_scan_laser,
           T_laser_scan = T_scan_laser.inverse()](const Eigen::Vector3d& step) {
            return T_reference_laser * Pose2::fromVector(step) * T_laser_scan;
          }};
}

/// The variables of ScanMotion. The direction's deviation is what moves the scan sideways by the
/// deviation of the translation.
Space odometrySpace(const Reference& reference, const View& scan, const Pose2& guess,
                    const ParticleConfig& config) {
  const ScanMotion motion(reference, scan);
  const Eigen::Vector3d start = motion.fromPose(guess);
  return {start,
          {std::atan2(config.translation_deviation, start[kDistance]), config.translation_deviation,
           config.rotation_deviation},
          [motion](const Eigen::Vector3d& variables) { return motion.toPose(variables); }};
}

struct Particle {
  Eigen::Vector3d variables;
  Pose2 T_reference_scan;
  double error;  // [m^2]
};

/// The particles of one match, which all begin at the guess.
class Population {
 public:
  Population(Space space, RayLandscape& landscape, const ParticleConfig& config, double noise)
      : space_(std::move(space)),
        landscape_(landscape),
        config_(config),
        least_error_(std::max(noise * noise, kLeastError)),
        random_(static_cast<std::uint64_t>(config.seed)),
        particles_(static_cast<std::size_t>(config.particles), particleAt(space_.guess)) {}

  [[nodiscard]] const Particle& best() const { return particles_.front(); }

  /// Picks particles in proportion to their fitness and draws a new one around each. The best stays
  /// as it is, in front.
  void resample() {
    if (landscape_.setStep(scale_ * config_.translation_deviation)) {
      particles_.front() = particleAt(best().variables);  // by the errors that count from now on
    }
    std::vector<Particle> next{best()};
    for (const std::size_t picked : pick()) {
      next.push_back(particleAt(drawAround(particles_[picked].variables)));
      if (next.back().error < next.front().error) {
        std::swap(next.back(), next.front());
      }
    }
    particles_ = std::move(next);
    scale_ *= config_.shrink;
  }

  /// Whether the particles have become one.
  [[nodiscard]] bool isTogether() const {
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (const Particle& particle : particles_) {
      squares +=
          relativePose(best().T_reference_scan, particle.T_reference_scan).vector().cwiseAbs2();
    }
    const auto count = static_cast<double>(particles_.size());
    return (squares / count).maxCoeff() < kTogether * kTogether;
  }

 private:
  [[nodiscard]] Particle particleAt(const Eigen::Vector3d& variables) const {
    const Pose2 pose = space_.toPose(variables);
    return {variables, pose, landscape_.error(pose)};
  }

  [[nodiscard]] Eigen::Vector3d drawAround(Eigen::Vector3d variables) {
    for (int i = 0; i < 3; ++i) {
      variables[i] += scale_ * space_.deviations[i] * normal_(random_);
    }
    return variables;
  }

  /// All but one of the next particles' parents: at even steps along the row of the fitnesses
  /// (systematic resampling), which picks each as often as its fitness asks for, rounded.
  [[nodiscard]] std::vector<std::size_t> pick() {
    std::vector<double> sums;
    double sum = 0.0;
    for (const Particle& particle : particles_) {
      sum += std::pow(particle.error + least_error_, -kSharpness);
      sums.push_back(sum);
    }
    const double step = sum / static_cast<double>(particles_.size() - 1);
    double mark = step * std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    std::vector<std::size_t> picked;
    std::size_t index = 0;
    while (picked.size() + 1 < particles_.size()) {
      while (sums[index] < mark && index + 1 < sums.size()) {
        ++index;
      }
      picked.push_back(index);
      mark += step;
    }
    return picked;
  }

  Space space_;
  RayLandscape& landscape_;
  const ParticleConfig& config_;
  double least_error_;  // [m^2] that noise leaves: lower is no fitter
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double scale_{1.0};  // of the deviations, now
  std::vector<Particle> particles_;
};

/// Whether something covers the laser.
bool tooManyNear(const View& scan, const ParticleConfig& config) {
  const auto near =
      std::count_if(scan.points.begin(), scan.points.end(), [&](const Eigen::Vector2d& point) {
        return (point - scan.origin).norm() < config.near_range;
      });
  return static_cast<double>(near) >
         config.max_near_share * static_cast<double>(scan.points.size());
}

}  // namespace

std::vector<std::string> particleSpaces() { return {kCartesian, kOdometry}; }

std::vector<std::string> ParticleConfig::validate() const {
  geometry::Violations violations;
  violations.requireWithin("particles", particles, 2, 100000);
  violations.requireWithin("rounds", rounds, 0, 1000);
  violations.requireAbove("translation_deviation", translation_deviation, 0.0);
  violations.requireAbove("rotation_deviation", rotation_deviation, 0.0);
  violations.requireAbove("shrink", shrink, 0.0);
  violations.requireWithin("shrink", shrink, 0.0, 1.0);
  violations.requireAtLeast("near_range", near_range, 0.0);
  violations.requireWithin("max_near_share", max_near_share, 0.0, 1.0);
  violations.requireAbove("error_cap", error_cap, 0.0);
  std::vector<std::string> sentences = violations.sentences();
  if (space != kCartesian && space != kOdometry) {
    sentences.push_back("space is \"" + space + "\", but must be \"cartesian\" or \"odometry\".");
  }
  return sentences;
}

ParticleMatcher::ParticleMatcher(const ParticleConfig& config, const MatchConfig& common)
    : config_(config), common_(common) {
  geometry::throwIfAny(config_.validate());
  geometry::throwIfAny(common_.validate());
}

MatchResult ParticleMatcher::match(const Reference& reference, const View& scan,
                                   const Pose2& guess) const {
  if (auto refused = refuseHopeless(reference, scan, guess, common_)) {
    return *refused;
  }
  if (tooManyNear(scan, config_)) {
    return refusal(guess, MatchFailure::kTooManyNear);
  }
  RayLandscape landscape(reference, scan, config_.error_cap);
  Population population(config_.space == kOdometry ? odometrySpace(reference, scan, guess, config_)
                                                   : cartesianSpace(scan, guess, config_),
                        landscape, config_, common_.range_noise);
  bool converged = false;
  for (int round = 0; round < config_.rounds && !converged; ++round) {
    population.resample();
    converged = population.isTogether();
  }
  return landscape.judge(population.best().T_reference_scan, converged, common_);
}

}  // namespace omega_slam::matching
