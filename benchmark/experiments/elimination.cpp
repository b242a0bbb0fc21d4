#include "experiments/elimination.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <map>

#include "experiments/contestants.h"
#include "experiments/cpu_timer.h"
#include "experiments/csv_file.h"
#include "experiments/match_account.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

const Tolerance kTolerance{0.05, geometry::degreesToRadians(1.0)};
constexpr const char* kInformation = "information";
constexpr std::uint32_t kEliminationStream = 2;

double highestLevel(OdometryNoise noise) {
  return noise == OdometryNoise::kTranslation ? 1.0 : geometry::kPi;
}

const char* nameOf(OdometryNoise noise) {
  return noise == OdometryNoise::kTranslation ? "translation" : "rotation";
}

/// A place of the experiment: all that does not change with the noise.
struct Place {
  Pose2 T_world_base;
  ScanError error;  // between two scans without noise
  Determination determination;
  Eigen::Matrix3d best_deviation;  // L of the best covariance L L^T; zero if not determined
};

Place surveyPlace(const Arena& arena, const Pose2& T_world_base) {
  const matching::View perfect = takePerfectScan(arena, T_world_base);
  const ScanPair pair{perfect, perfect, {}};
  Place place{T_world_base, ScanError(perfect, perfect),
              determinationOf(pair, rangeDeviation, kTolerance), Eigen::Matrix3d::Zero()};
  if (place.determination == Determination::kDetermined) {
    place.best_deviation = informationOf(pair, rangeDeviation).inverse().llt().matrixL();
  }
  return place;
}

/// Two scans of a place, and what the odometry says of the second.
struct Trial {
  const Place& place;
  Pose2 odometry;  // T_reference_scan; in truth the identity
  TwoScans scans;
};

/// Judges estimates of one trial.
class Judge {
 public:
  explicit Judge(const Trial& trial)
      : place_(trial.place),
        measured_(trial.scans.reference, trial.scans.scan),
        before_(place_.error.at(trial.odometry)),
        measured_before_(measured_.at(trial.odometry)) {}

  [[nodiscard]] MatchOutcome outcomeOf(const Pose2& estimate, bool trusted) const {
    MatchOutcome outcome;
    outcome.squared_error_before = before_;
    outcome.squared_error_after = place_.error.at(estimate);
    outcome.measured_error_before = measured_before_;
    outcome.measured_error_after = measured_.at(estimate);
    outcome.error = errorOf(estimate, {});
    outcome.determined = place_.determination == Determination::kDetermined;
    outcome.trusted = trusted;
    return outcome;
  }

 private:
  const Place& place_;
  ScanError measured_;
  double before_;
  double measured_before_;
};

Pose2 drawBestEstimate(const Place& place, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d units;
  for (double& unit : units) {
    unit = normal(random);
  }
  return Pose2::fromVector(place.best_deviation * units);
}

/// All matches of one level.
class Level {
 public:
  void play(const Trial& trial, const std::vector<Contestant>& contestants,
            std::map<std::string, double>& seconds, std::mt19937_64& random) {
    const Judge judge(trial);
    for (const Contestant& contestant : contestants) {
      const CpuTimer timer;
      const auto result =
          contestant.matcher->match({trial.scans.reference}, trial.scans.scan, trial.odometry);
      seconds[contestant.name] += timer.seconds();
      add(contestant.name, judge.outcomeOf(result.T_reference_scan, isTrusted(result)));
    }
    if (trial.place.determination == Determination::kDetermined) {
      add(kInformation, judge.outcomeOf(drawBestEstimate(trial.place, random), true));
    }
  }

  void write(double level, CsvFile& csv) const {
    for (const auto& [name, account] : accounts_) {
      csv.row(name, level, account.count(), account.determined(), account.quotient(),
              account.quotientOfDetermined(), account.medianQuotient(), account.measuredQuotient(),
              account.within(), account.withinOfDetermined(), account.trusted(),
              account.trustedAndWrong());
    }
  }

 private:
  void add(const std::string& name, const MatchOutcome& outcome) {
    accounts_.try_emplace(name, kTolerance).first->second.add(outcome);
  }

  std::map<std::string, MatchAccount> accounts_;
};

Tolerance guessErrorOf(OdometryNoise noise) {
  return noise == OdometryNoise::kTranslation ? Tolerance{highestLevel(noise), 0.0}
                                              : Tolerance{0.0, highestLevel(noise)};
}

void writePlaces(const std::vector<Place>& places, const std::filesystem::path& path) {
  std::map<Determination, std::size_t> count;
  for (const Place& place : places) {
    ++count[place.determination];
  }
  CsvFile csv(path, "places,determined,too_few_returns,open_direction");
  csv.row(places.size(), count[Determination::kDetermined], count[Determination::kTooFewReturns],
          count[Determination::kOpenDirection]);
}

}  // namespace

void runElimination(const Arena& arena, const EliminationOptions& options,
                    const std::filesystem::path& folder, const Progress& progress) {
  const std::string suffix = arena.name + "_" + nameOf(options.noise) + ".csv";
  const auto contestants = ownMatchers(guessErrorOf(options.noise), options.matchers);
  std::vector<Place> places;
  for (const Pose2& T_world_base : drawPlaces(arena, options.scans, options.seed)) {
    places.push_back(surveyPlace(arena, T_world_base));
  }
  writePlaces(places, folder / ("places_" + suffix));
  CsvFile csv(folder / ("elimination_" + suffix),
              "matcher,level,matches,determined,quotient,quotient_determined,median_quotient,"
              "measured_quotient,within,within_determined,trusted,trusted_wrong");
  std::map<std::string, double> seconds;
  for (std::size_t l = 1; l <= options.levels; ++l) {
    const double level =
        highestLevel(options.noise) * static_cast<double>(l) / static_cast<double>(options.levels);
    Level matches;
    for (std::size_t k = 0; k < places.size(); ++k) {
      auto random = generatorFor({options.seed, kEliminationStream, static_cast<std::uint32_t>(k),
                                  static_cast<std::uint32_t>(l)});
      const Pose2 odometry = drawOdometry(options.noise, level, random);
      const Trial trial{places[k], odometry, takeTwoScans(arena, places[k].T_world_base, random)};
      matches.play(trial, contestants, seconds, random);
    }
    matches.write(level, csv);
    progress(l, options.levels);
  }
  CsvFile times(folder / ("seconds_" + suffix), "matcher,matches,seconds");
  for (const auto& [name, sum] : seconds) {
    times.row(name, options.levels * options.scans, sum);
  }
}

}  // namespace omega_slam::experiments
