#include "nodes/common/run_recorder_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "omega_slam/grid/map_file.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam {
namespace {

constexpr char kScanMatcher[] = "scan_matcher";

std::size_t total(const std::map<std::string, std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                         [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

void judgeTrajectory(const RunRecord& record, evaluation::Report& report) {
  const geometry::Trajectory truth = record.truth();
  const auto error = evaluation::absoluteTrajectoryError(record.estimate(), truth);
  if (error.matched == 0) {
    return;
  }
  report.trajectory_error = error;
  const auto wheels = evaluation::absoluteTrajectoryError(record.odometry(), truth).translation;
  report.notes.push_back(
      fmt::format("The odometry alone is {:.2f} m off in the mean, {:.2f} m at most.", wheels.mean,
                  wheels.max));
}

void judgeMap(const RunRecord& record, const TrueWorld& world, evaluation::Report& report) {
  if (report.trajectory_error && !record.map().cells.empty()) {
    report.resemblance = evaluation::compareMaps(
        record.map(), world.map, {report.trajectory_error->T_truth_map, world.start});
  }
}

/// Those that were withdrawn are listed, but not counted.
std::ptrdiff_t loopsInForce(const evaluation::Report& report) {
  const auto loops = report.loops.value_or(std::vector<evaluation::LoopFigures>{});
  return std::count_if(loops.begin(), loops.end(),
                       [](const evaluation::LoopFigures& loop) { return loop.weight != 0.0; });
}

void tellOfRefusals(const RunAccounts& accounts, evaluation::Report& report) {
  for (const auto& [node, figures] : accounts.nodes()) {
    if (node == kScanMatcher) {
      report.scans = figures;
    } else if (const std::size_t refused = total(figures.rejections); refused > 0) {
      report.notes.push_back(fmt::format("{} refused {} of its inputs.", node, refused));
    }
  }
}

}  // namespace

TrueWorld loadTrueWorld(const std::string& path) {
  const simulation::WorldFile file = simulation::readWorldFile(path);
  TrueWorld world;
  // Of "lab.world.yaml", "lab".
  world.name = std::filesystem::path(path).stem().stem().string();
  world.map = grid::toOccupancyGrid(grid::loadMapImage(file.map));
  world.start = file.start.translation();
  return world;
}

evaluation::Report makeReport(const RunRecord& record, const RunEnding& ending,
                              const RunAccounts& accounts, const std::optional<TrueWorld>& world) {
  evaluation::Report report;
  report.input = world ? "simulated run in the world " + world->name : "simulated run";
  report.duration = record.elapsed();
  report.distance = record.distance();
  report.keyframes = record.graph().poses.size();
  const slam::BeliefAccount& beliefs = record.beliefs();
  report.loops =
      evaluation::loopFigures(record.graph(), beliefs.weights, beliefs.withdrawn, beliefs.folded);
  report.notes.push_back("The run ended: " + ending.reason + ".");
  if (!ending.settled) {
    report.notes.push_back("The map was saved before it had caught up with the newest scans.");
  }
  if (record.map().cells.empty()) {
    report.notes.push_back("There is no map: none has been received.");
  } else {
    report.map = record.map().geometry;
  }
  if (!beliefs.withdrawn.empty()) {
    report.notes.push_back(fmt::format("{} loops were withdrawn: all else contradicts them.",
                                       beliefs.withdrawn.size()));
  }
  if (!beliefs.folded.empty()) {
    report.notes.push_back(
        fmt::format("{} loops went with keyframes that have retired.", beliefs.folded.size()));
  }
  judgeTrajectory(record, report);
  if (world) {
    judgeMap(record, *world, report);
  }
  tellOfRefusals(accounts, report);
  return report;
}

std::string formatClosing(const evaluation::Report& report, const RunEnding& ending) {
  std::string text = fmt::format(
      "{}: {:.0f} s simulated in {:.0f} s, {:.1f} m driven, {} keyframes, {} loops.\n",
      ending.reason, report.duration.value_or(0.0), ending.wall_time, report.distance.value_or(0.0),
      report.keyframes.value_or(0), loopsInForce(report));
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (report.trajectory_error) {
    const auto& error = report.trajectory_error->translation;
    text += fmt::format("Trajectory: {:.3f} m off in the mean, {:.3f} m at most.\n", error.mean,
                        error.max);
  }
  if (report.resemblance) {
    text +=
        fmt::format("Map: {:.1f} % of its cells are right, {:.0f} % of the world was seen.\n",
                    100.0 * report.resemblance->score(), 100.0 * report.resemblance->coverage());
  }
  if (report.scans) {
    text += fmt::format("Scans: {} used, {} rejected.\n", report.scans->used,
                        total(report.scans->rejections));
  }
  if (!report.map) {
    text += "There is no map: none has been received.\n";
  }
  return text;
}

}  // namespace omega_slam
