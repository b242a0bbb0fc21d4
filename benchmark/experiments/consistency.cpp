#include "experiments/consistency.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <map>

#include "experiments/contestants.h"
#include "experiments/csv_file.h"
#include "experiments/match_account.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr std::uint32_t kConsistencyStream = 6;
const Tolerance kGuessError{0.1, geometry::degreesToRadians(5.0)};

struct TwoPlaces {
  Pose2 T_world_first;
  Pose2 T_first_second;
};

/// The robot fits at both, and half way between them.
TwoPlaces drawTwoPlaces(const Arena& arena, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  while (true) {
    TwoPlaces places;
    places.T_world_first = drawFreePose(arena, random);
    const double distance = 0.3 + 0.2 * unit(random);
    const double direction = geometry::kPi * unit(random);
    const double turn = 0.35 * unit(random);
    places.T_first_second = {distance * std::cos(direction), distance * std::sin(direction), turn};
    const Pose2 T_world_second = places.T_world_first * places.T_first_second;
    const Pose2 between = interpolate(places.T_world_first, T_world_second, 0.5);
    if (isFree(arena, T_world_second.translation()) && isFree(arena, between.translation())) {
      return places;
    }
  }
}

Pose2 drawGuess(const Pose2& truth, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double distance = kGuessError.translation * std::sqrt(std::abs(unit(random)));
  const double direction = geometry::kPi * unit(random);
  return {truth.x + distance * std::cos(direction), truth.y + distance * std::sin(direction),
          geometry::normalizeAngle(truth.theta + kGuessError.rotation * unit(random))};
}

/// Of the matches that say the same of themselves.
struct Consistency {
  std::size_t count{0};
  std::size_t inside{0};
  double sum{0.0};

  void add(double squared_length) {
    ++count;
    inside += squared_length <= kThreeSigma ? 1 : 0;
    sum += squared_length;
  }
  [[nodiscard]] double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
};

struct Claims {
  Consistency trusted;
  Consistency all;  // that claim a covariance
};

}  // namespace

double squaredMahalanobis(const matching::MatchResult& result, const Pose2& truth) {
  const Pose2& found = result.T_reference_scan;
  const Eigen::Vector3d error(found.x - truth.x, found.y - truth.y,
                              geometry::angleDifference(found.theta, truth.theta));
  return error.dot(result.covariance.ldlt().solve(error));
}

void runConsistency(const Arena& arena, const ConsistencyOptions& options,
                    const std::filesystem::path& folder, const Progress& progress) {
  const auto contestants = ownMatchers(kGuessError, options.matchers);
  std::map<std::string, Claims> claims;
  for (std::uint32_t k = 0; k < options.pairs; ++k) {
    auto random = generatorFor({options.seed, kConsistencyStream, k});
    const TwoPlaces places = drawTwoPlaces(arena, random);
    const matching::View reference = takeScan(arena, places.T_world_first, random);
    const matching::View scan =
        takeScan(arena, places.T_world_first * places.T_first_second, random);
    const Pose2 guess = drawGuess(places.T_first_second, random);
    for (const Contestant& contestant : contestants) {
      const auto result = contestant.matcher->match({reference}, scan, guess);
      const double squared_length = squaredMahalanobis(result, places.T_first_second);
      const bool trusted = isTrusted(result);
      if (trusted) {
        claims[contestant.name].trusted.add(squared_length);
      }
      if (trusted || result.failure == matching::MatchFailure::kDegenerate) {
        claims[contestant.name].all.add(squared_length);
      }
    }
    progress(k + 1, options.pairs);
  }
  CsvFile csv(folder / ("consistency_" + arena.name + ".csv"),
              "matcher,pairs,trusted,inside,mean_squared_length,claiming,inside_of_claiming,"
              "mean_squared_length_of_claiming");
  for (const auto& [name, claim] : claims) {
    csv.row(name, options.pairs, claim.trusted.count,
            shareOf(claim.trusted.inside, claim.trusted.count), claim.trusted.mean(),
            claim.all.count, shareOf(claim.all.inside, claim.all.count), claim.all.mean());
  }
}

}  // namespace omega_slam::experiments
