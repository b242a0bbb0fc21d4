// SLAM of a recording, as fast as the CPU: the same objects that the nodes run, wired by function
// calls.

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/config/slam_config.h"
#include "omega_slam/evaluation/relations.h"
#include "omega_slam/evaluation/report.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/io/log_source.h"
#include "omega_slam/io/trajectory_file.h"
#include "omega_slam/results/run_results.h"
#include "omega_slam/slam/pipeline.h"
#include "tools/progress_bar.h"
#ifdef OMEGA_SLAM_WITH_ROS
#include "nodes/common/bag_log.h"
#endif

namespace omega_slam {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

struct Arguments {
  std::string input;
  std::string out{"results"};
  std::string config;
  std::string relations;
  std::string odometry;
  std::string scan_topic;
  std::string odom_topic;
  std::string base_frame;
  std::vector<double> laser_pose;
  double limit{0.0};
};

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("INPUT", arguments.input,
                 "recording: a rosbag (.bag), a rover's log (.dat) or a CARMEN log")
      ->required();
  app.add_option("--out", arguments.out, "folder for the results")->capture_default_str();
  app.add_option("--config", arguments.config,
                 "parameters, in the form of config/slam.yaml (default: built in)");
  app.add_option("--relations", arguments.relations,
                 "ground-truth relations to score the trajectory with");
  app.add_option("--odometry", arguments.odometry,
                 "dense odometry 't x y theta', by which the relations' stamps are met");
  app.add_option("--scan-topic", arguments.scan_topic, "of a bag; default: the only one there is");
  app.add_option("--odom-topic", arguments.odom_topic,
                 "of a bag; 'tf' for the transform; default: messages if any, else tf");
  app.add_option("--base-frame", arguments.base_frame,
                 "of a bag; default: as the odometry says, else base_footprint, else base_link");
  app.add_option("--laser-pose", arguments.laser_pose,
                 "X Y YAW of the laser on the robot [m m rad], where the recording has none")
      ->expected(3);
  app.add_option("--limit", arguments.limit, "stop after so many seconds of the recording");
}

std::unique_ptr<io::ScanSource> openSource(const Arguments& arguments) {
  std::optional<geometry::Pose2> laser_pose;
  if (!arguments.laser_pose.empty()) {
    laser_pose = {arguments.laser_pose[0], arguments.laser_pose[1], arguments.laser_pose[2]};
  }
  if (!std::filesystem::exists(arguments.input)) {
    throw std::runtime_error(fmt::format("{}: there is no such file.", arguments.input));
  }
  if (std::filesystem::path(arguments.input).extension() != ".bag") {
    return io::openLog(arguments.input, laser_pose);
  }
#ifdef OMEGA_SLAM_WITH_ROS
  BagLogOptions options;
  options.scan_topic = arguments.scan_topic;
  options.odometry_topic = arguments.odom_topic;
  options.base_frame = arguments.base_frame;
  options.laser_pose = laser_pose;
  return std::make_unique<BagLog>(arguments.input, options);
#else
  throw std::runtime_error(
      fmt::format("{}: this build has no ROS and can't read bags.", arguments.input));
#endif
}

/// All that is counted while the recording is played.
struct Account {
  evaluation::ScanFigures scans;
  std::size_t keyframes{0};
  std::size_t untrusted{0};
  std::size_t lost{0};
  std::size_t loops{0};
  std::vector<double> seconds;  // for each scan

  void add(const slam::ScanOutcome& outcome, double took) {
    seconds.push_back(took);
    scans.used += outcome.rejection.empty() ? 1 : 0;
    scans.rejections[outcome.rejection] += outcome.rejection.empty() ? 0 : 1;
    for (const std::string& repair : outcome.repairs) {
      ++scans.repairs[repair];
    }
    keyframes += outcome.keyframe ? 1 : 0;
    untrusted += outcome.match_untrusted ? 1 : 0;
    lost += outcome.is_lost ? 1 : 0;
    loops += outcome.loops;
  }
};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Plays the recording to its end, to the limit, or until Ctrl-C.
Account play(io::ScanSource& source, slam::Pipeline& pipeline, double limit) {
  Account account;
  ProgressBar progress;
  std::optional<double> first_stamp;
  while (const auto record = source.next()) {
    first_stamp = first_stamp.value_or(record->scan.stamp);
    if (interrupted != 0 || (limit > 0.0 && record->scan.stamp - *first_stamp > limit)) {
      break;
    }
    const auto start = Clock::now();
    const slam::ScanOutcome outcome = pipeline.process(
        record->scan, record->mount, record->T_odom_base, record->motion_during_sweep);
    account.add(outcome, secondsSince(start));
    progress.show(source.progress(),
                  fmt::format("{} scans, {} keyframes, {} loops", account.seconds.size(),
                              account.keyframes, account.loops));
  }
  progress.finish();
  for (const auto& [cause, count] : source.dropped()) {
    account.scans.rejections[cause] += count;
  }
  account.scans.rejections.erase("");
  return account;
}

/// What went wrong, or was mended, a sentence each.
std::vector<std::string> notesOn(const Account& account, const slam::Pipeline& pipeline,
                                 const graph::SolveReport& solved) {
  std::vector<std::string> notes;
  if (account.untrusted > 0) {
    notes.push_back(fmt::format(
        "At {} scans the match was not trusted and the odometry stood alone.", account.untrusted));
  }
  if (account.lost > 0) {
    notes.push_back(fmt::format("At {} scans the robot was lost: what it saw contradicted the map.",
                                account.lost));
  }
  if (!pipeline.withdrawnLoops().empty()) {
    notes.push_back(fmt::format("{} loops were withdrawn: all else contradicts them.",
                                pipeline.withdrawnLoops().size()));
  }
  if (pipeline.retiredKeyframes() > 0) {
    notes.push_back(fmt::format("{} keyframes have retired from the graph, and {} loops with them.",
                                pipeline.retiredKeyframes(), pipeline.foldedLoops().size()));
  }
  if (const std::string faults = describe(pipeline.odometryFaults()); !faults.empty()) {
    notes.push_back("The odometry is wrong throughout, and was corrected: " + faults + ".");
  }
  if (!solved.message.empty()) {
    notes.push_back("The last solve failed: " + solved.message + ".");
  }
  return notes;
}

/// What a trajectory is scored with.
struct Truth {
  std::vector<graph::Relation> relations;
  geometry::Trajectory odometry;
};

/// @return none where no relations were given
std::optional<Truth> readTruth(const Arguments& arguments) {
  if (arguments.relations.empty()) {
    return std::nullopt;
  }
  return Truth{io::readRelations(arguments.relations), arguments.odometry.empty()
                                                           ? geometry::Trajectory{}
                                                           : io::readOdometry(arguments.odometry)};
}

void describe(const Arguments& arguments, const std::optional<Truth>& truth,
              const slam::Pipeline& pipeline, const Account& account,
              const graph::SolveReport& solved, results::RunResults& results) {
  evaluation::Report& report = results.report;
  report.input = std::filesystem::path(arguments.input).filename().string();
  if (!results.estimate.empty()) {
    const auto [first, last] =
        std::minmax_element(results.estimate.begin(), results.estimate.end(),
                            [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
    report.duration = last->stamp - first->stamp;
  }
  report.distance = evaluation::pathLength(results.estimate);
  report.scans = account.scans;
  report.keyframes = account.keyframes;
  report.loops = evaluation::loopFigures(pipeline.graph(), solved.weights,
                                         pipeline.withdrawnLoops(), pipeline.foldedLoops());
  report.chi_square = solved.chi_square;
  report.map = results.map.geometry;
  report.notes = notesOn(account, pipeline, solved);
  if (truth) {
    report.relations =
        evaluation::scoreRelations(results.estimate, truth->relations, truth->odometry);
  }
}

long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

void printSummary(const Arguments& arguments, const results::RunResults& results,
                  const Account& account, double seconds) {
  const auto& report = results.report;
  const auto& timing = results.timings.front();
  fmt::print(
      "{} scans in {:.1f} s: {:.2f} ms a scan (median; 99 % below {:.2f}, worst {:.2f}), "
      "{} MB at most.\n",
      timing.count, seconds, 1e3 * timing.median, 1e3 * timing.percentile_99, 1e3 * timing.max,
      peakMegabytes());
  fmt::print("{} keyframes, {} loops, {:.1f} m driven.\n", account.keyframes, account.loops,
             report.distance.value_or(0.0));
  for (const auto& [cause, count] : account.scans.rejections) {
    fmt::print("{} scans were left out: {}.\n", count, cause);
  }
  for (const auto& [repair, count] : account.scans.repairs) {
    fmt::print("{} scans were repaired: {}.\n", count, repair);
  }
  if (report.relations) {
    fmt::print("Relations: {} of {} covered, {:.4f} +- {:.4f} m, {:.3f} +- {:.3f} deg.\n",
               report.relations->covered, report.relations->relations,
               report.relations->translation.mean, report.relations->translation.deviation,
               geometry::radiansToDegrees(report.relations->rotation.mean),
               geometry::radiansToDegrees(report.relations->rotation.deviation));
  }
  fmt::print("Results are in {}.\n", arguments.out);
}

int run(const Arguments& arguments) {
  const config::SlamConfig config =
      arguments.config.empty() ? config::SlamConfig{} : config::loadSlamConfig(arguments.config);
  const auto truth = readTruth(arguments);  // before the long work
  const auto source = openSource(arguments);
  fmt::print(stderr, "{}: {}\n", arguments.input, source->description());
  const auto start = Clock::now();
  slam::Pipeline pipeline(config::pipelineConfig(config));
  const Account account = play(*source, pipeline, arguments.limit);
  const auto solve_start = Clock::now();
  const graph::SolveReport solved = pipeline.finish();
  const auto map_start = Clock::now();

  results::RunResults results;
  results.map = pipeline.map(config.map_builder.mapper);
  results.timings = {
      evaluation::summarizeTimes("scan", account.seconds),
      evaluation::summarizeTimes("map", {secondsSince(map_start)}),
      evaluation::summarizeTimes("last solve",
                                 {std::chrono::duration<double>(map_start - solve_start).count()})};
  results.estimate = pipeline.trajectory();
  results.graph = pipeline.graph();
  describe(arguments, truth, pipeline, account, solved, results);
  const auto faults = results::writeResults(arguments.out, results);
  for (const std::string& fault : faults) {
    fmt::print(stderr, "omega_slam_offline: {}\n", fault);
  }
  if (account.seconds.empty()) {
    throw std::runtime_error(arguments.input + ": not one scan could be used.");
  }
  printSummary(arguments, results, account, secondsSince(start));
  return faults.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace omega_slam

int main(int argc, char** argv) {
  CLI::App app(
      "Maps a recording: reads laser scans and odometry, closes loops, and writes map.pgm, "
      "map.yaml, map.png, "
      "trajectory.tum, graph.g2o and a report. Ctrl-C ends early and still saves.");
  omega_slam::Arguments arguments;
  omega_slam::declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  std::signal(SIGINT, [](int) { omega_slam::interrupted = 1; });
  try {
    return omega_slam::run(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "omega_slam_offline: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
