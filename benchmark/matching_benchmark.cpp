// How long a match takes: every matcher on scans of a simulated Hokuyo URG (683 beams) and on key
// scans of the Intel Research Lab (180 beams; where OMEGA_SLAM_DATA leads to its log), beside PCL's
// ICP and NDT; and how long one scan of a drive takes that is tracked on a map, the map's update
// included. Closes with a table of ratios to PCL's ICP of the same run.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/contestants.h"
#include "experiments/key_pairs.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/matching/correlative_matcher.h"
#include "omega_slam/matching/map_matcher.h"

namespace omega_slam::experiments {
namespace {

constexpr std::size_t kPairs = 50;
constexpr std::size_t kRecordedScans = 600;
constexpr std::size_t kDriveScans = 600;
constexpr double kMapStep = 0.4;  // [m], [rad] between scans that are put into a map
constexpr const char* kUnitOfTime = "pcl_icp";
const Tolerance kGuessError{0.1, geometry::degreesToRadians(5.0)};

/// Matches pair after pair; a guess is off by most of what the matchers are set up for.
void matchInTurn(benchmark::State& state, const matching::ScanMatcher& matcher,
                 const std::vector<ScanPair>& pairs) {
  std::size_t k = 0;
  for (auto _ : state) {
    const ScanPair& pair = pairs[k % pairs.size()];
    const double side = k % 2 == 0 ? 0.7 : -0.7;
    const geometry::Pose2& truth = pair.T_reference_scan;
    const geometry::Pose2 guess{truth.x + side * kGuessError.translation, truth.y,
                                truth.theta + side * kGuessError.rotation};
    benchmark::DoNotOptimize(matcher.match({pair.reference}, pair.scan, guess));
    ++k;
  }
}

/// Follows a drive from scan to scan, and puts one into the map where the robot has moved on.
void trackInTurn(benchmark::State& state, const matching::MapMatcher& matcher, const Drive& drive) {
  matching::LocalMap map;
  geometry::Pose2 T_map_base;
  geometry::Pose2 T_map_newest;
  std::size_t k = 0;
  for (auto _ : state) {
    bool moved_on = k == 0;
    if (k > 0) {
      const auto step = relativePose(drive.T_odom_base[k - 1], drive.T_odom_base[k]);
      T_map_base = matcher.track(map, drive.views[k], T_map_base * step).T_reference_scan;
      const auto way = relativePose(T_map_newest, T_map_base);
      moved_on = way.translation().norm() > kMapStep || std::abs(way.theta) > kMapStep;
    }
    if (moved_on) {
      benchmark::DoNotOptimize(map.insert(drive.views[k], T_map_base));
      T_map_newest = T_map_base;
    }
    k = (k + 1) % drive.views.size();
    if (k == 0) {
      map.clear();
    }
  }
}

/// Prints as the console reporter does, and closes with the table of ratios.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) {
        continue;  // a deviation is no time
      }
      const std::string name = run.run_name.function_name;
      const double time = run.GetAdjustedCPUTime();
      const auto known = least_.find(name);
      least_[name] = known == least_.end() ? time : std::min(known->second, time);
    }
    ConsoleReporter::ReportRuns(runs);
  }

  void Finalize() override {
    fmt::print("\n{:<32}{:>12}\n", "least time of all repetitions", "PCL ICP = 1");
    for (const auto& [name, time] : least_) {
      const auto unit = least_.find(name.substr(0, name.find('/') + 1) + kUnitOfTime);
      if (unit != least_.end()) {
        fmt::print("{:<32}{:>12.3f}\n", name, time / unit->second);
      }
    }
  }

 private:
  std::map<std::string, double> least_;  // name -> time
};

std::vector<Contestant> everybody() {
  std::vector<Contestant> contestants = ownMatchers(kGuessError);
  for (Contestant& peer : peers()) {
    contestants.push_back(std::move(peer));
  }
  return contestants;
}

struct Scans {
  std::vector<ScanPair> pairs;
  Drive drive;
};

std::map<std::string, Scans> collectScans() {
  std::map<std::string, Scans> scans;
  const Arena lab = loadArena("lab", OMEGA_SLAM_SOURCE_DIR "/maps/lab.yaml");
  scans["urg_683_beams"] = {strollPairs(lab, kPairs, 1).pairs, strollDrive(lab, kDriveScans, 1)};
  const char* data = std::getenv("OMEGA_SLAM_DATA");
  const auto log = std::filesystem::path(data == nullptr ? "" : data) /
                   "logs/intel/intel_5505_first1088s_rawodom.clf";
  if (std::filesystem::exists(log)) {
    scans["intel_180_beams"] = {recordedPairs(log, kRecordedScans).pairs,
                                recordedDrive(log, kDriveScans)};
  }
  return scans;
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  using namespace omega_slam::experiments;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return EXIT_FAILURE;
  }
  const auto contestants = everybody();
  const auto sources = collectScans();
  const omega_slam::matching::MapMatcher map_matcher(
      {}, {}, std::make_unique<omega_slam::matching::CorrelativeMatcher>());
  for (const auto& source : sources) {
    const Scans& scans = source.second;
    for (const Contestant& contestant : contestants) {
      const std::string name = source.first + "/" + contestant.name;
      benchmark::RegisterBenchmark(name.c_str(), [&](benchmark::State& state) {
        matchInTurn(state, *contestant.matcher, scans.pairs);
      })->Unit(benchmark::kMicrosecond);
    }
    const std::string name = source.first + "/scan_to_map_tracking";
    benchmark::RegisterBenchmark(name.c_str(), [&](benchmark::State& state) {
      trackInTurn(state, map_matcher, scans.drive);
    })->Unit(benchmark::kMicrosecond);
  }
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return EXIT_SUCCESS;
}
