#include "experiments/reliability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "experiments/contestants.h"
#include "experiments/cpu_timer.h"
#include "experiments/csv_file.h"
#include "experiments/match_account.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

const Tolerance kTolerance{0.1, geometry::degreesToRadians(2.0)};
constexpr std::uint32_t kReliabilityStream = 5;
constexpr const char* kUnitOfTime = "pcl_icp";

/// A kind of guess.
struct Scenario {
  const char* name;
  Tolerance guess_error;
  bool exactly;        // else uniformly up to it
  std::size_t stride;  // every so manieth pair
  bool with_peers;
};

const std::array<Scenario, 3> kScenarios{{
    {"near", {0.1, geometry::degreesToRadians(5.0)}, false, 1, true},
    {"far", {0.5, geometry::degreesToRadians(30.0)}, true, 1, true},
    {"anywhere", {4.0, geometry::kPi}, false, 10, false},
}};

Pose2 drawGuess(const Pose2& truth, const Scenario& scenario, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  // The root: uniform over the disc, not crowded at its middle.
  const double length =
      scenario.guess_error.translation * (scenario.exactly ? 1.0 : std::sqrt(unit(random)));
  const double direction = 2.0 * geometry::kPi * unit(random);
  const double share = scenario.exactly ? 1.0 : unit(random);
  const double side = unit(random) < 0.5 ? -1.0 : 1.0;
  return {truth.x + length * std::cos(direction), truth.y + length * std::sin(direction),
          geometry::normalizeAngle(truth.theta + side * share * scenario.guess_error.rotation)};
}

/// What is said of one matcher.
struct Record {
  MatchAccount account{kTolerance};
  double seconds{0.0};
  std::size_t timed{0};
};

using Records = std::map<std::string, Record>;

void matchPair(const Contestant& contestant, const ScanPair& pair, const Pose2& guess,
               bool determined, Record& record) {
  constexpr int kRuns = 3;
  matching::MatchResult result;
  double least = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const CpuTimer timer;
    result = contestant.matcher->match({pair.reference}, pair.scan, guess);
    const double seconds = timer.seconds();
    least = run == 0 ? seconds : std::min(least, seconds);
  }
  MatchOutcome outcome;
  outcome.error = errorOf(result.T_reference_scan, pair.T_reference_scan);
  outcome.determined = determined;
  outcome.trusted = isTrusted(result);
  record.account.add(outcome);
  record.seconds += least;
  ++record.timed;
}

/// All matches of one kind of guess. Matchers take turns at each pair, so that all of them find the
/// machine in the same state.
class Contest {
 public:
  Contest(const Scenario& scenario, const std::vector<std::string>& names)
      : scenario_(scenario), contestants_(ownMatchers(scenario.guess_error, names)) {
    if (scenario.with_peers) {
      for (Contestant& peer : peers()) {
        contestants_.push_back(std::move(peer));
      }
    }
  }

  void play(const KeyPairs& found, std::uint32_t seed, const Progress& progress) {
    for (std::size_t k = 0; k < found.pairs.size(); k += scenario_.stride) {
      auto random = generatorFor({seed, kReliabilityStream, static_cast<std::uint32_t>(k)});
      const ScanPair& pair = found.pairs[k];
      const Pose2 guess = drawGuess(pair.T_reference_scan, scenario_, random);
      const bool determined =
          determinationOf(pair, found.deviation, kTolerance) == Determination::kDetermined;
      for (const Contestant& contestant : contestants_) {
        matchPair(contestant, pair, guess, determined, records_[contestant.name]);
      }
      progress(k + 1, found.pairs.size());
    }
  }

  [[nodiscard]] const Records& records() const { return records_; }

 private:
  const Scenario& scenario_;
  std::vector<Contestant> contestants_;
  Records records_;
};

double secondsPerMatch(const Record& record) {
  return record.seconds / static_cast<double>(std::max<std::size_t>(record.timed, 1));
}

}  // namespace

void runReliability(const std::string& source, const KeyPairs& pairs, std::uint32_t seed,
                    const std::vector<std::string>& names, const std::filesystem::path& folder,
                    const Progress& progress) {
  CsvFile csv(folder / ("reliability_" + source + ".csv"),
              "guess,matcher,pairs,determined,within,within_determined,trusted,trusted_wrong");
  CsvFile speed(folder / ("speed_" + source + ".csv"), "guess,matcher,microseconds,of_pcl_icp");
  double unit = 0.0;
  std::size_t scenarios_done = 0;
  for (const Scenario& scenario : kScenarios) {
    Contest contest(scenario, names);
    contest.play(pairs, seed, [&](std::size_t done, std::size_t all) {
      progress(scenarios_done * all + done, kScenarios.size() * all);
    });
    ++scenarios_done;
    unit = unit > 0.0 ? unit : secondsPerMatch(contest.records().at(kUnitOfTime));
    for (const auto& [name, record] : contest.records()) {
      const MatchAccount& account = record.account;
      csv.row(scenario.name, name, account.count(), account.determined(), account.within(),
              account.withinOfDetermined(), account.trusted(), account.trustedAndWrong());
      speed.row(scenario.name, name, 1e6 * secondsPerMatch(record), secondsPerMatch(record) / unit);
    }
  }
}

}  // namespace omega_slam::experiments
