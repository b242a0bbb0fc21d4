#include "graph/long_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/cpu_timer.h"
#include "experiments/resident_memory.h"
#include "graph/arrivals.h"
#include "omega_slam/evaluation/report.h"
#include "omega_slam/graph/marginals.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using geometry::relativePose;

namespace {

constexpr std::size_t kShortWhile = 500;  // [keyframes]

/// What one hour came to.
struct Hour {
  std::vector<double> seconds;  ///< of each update
  double error{0.0};            ///< [m] sums over its keyframes
  double relative_error{0.0};
};

/// How far the newest keyframe is from the truth, seen from the first one and from one a short
/// while ago.
void addErrors(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth, Hour& hour) {
  const std::size_t newest = poses.size() - 1;
  const auto errorFrom = [&](std::size_t other) {
    return geometry::distance(relativePose(poses[other], poses[newest]),
                              relativePose(truth[other], truth[newest]));
  };
  hour.error += errorFrom(0);
  hour.relative_error += errorFrom(newest - std::min(newest, kShortWhile));
}

/// [m] standard deviation of the newest keyframe's position, as the graph states it.
double statedDeviation(const graph::PoseGraph& graph) {
  const graph::Marginals marginals(graph);
  const auto newest = static_cast<graph::NodeId>(graph.poses.size() - 1);
  return std::sqrt(marginals.covariance(newest).topLeftCorner<2, 2>().trace());
}

std::string rowOf(const Hour& hour, const slam::BackEnd& back_end, double bytes) {
  const auto times = evaluation::summarizeTimes("update", hour.seconds);
  const auto count = static_cast<double>(times.count);
  const graph::PoseGraph& graph = back_end.graph();
  return fmt::format("{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.1f},{:.4f},{:.4f},{:.4f}\n",
                     graph.poses.size(), graph.poses.size() - back_end.retired(),
                     graph.constraints.size(), 1e3 * times.total / count, 1e3 * times.median,
                     1e3 * times.percentile_99, 1e3 * times.max, bytes / (1024.0 * 1024.0),
                     hour.error / count, statedDeviation(graph), hour.relative_error / count);
}

}  // namespace

ManhattanWorld driveForHours(const LongDriveConfig& config) {
  ManhattanConfig town;
  town.poses = config.keyframes;
  town.visits = static_cast<double>(config.keyframes) / static_cast<double>(config.crossings);
  town.returns_a_loop = config.returns_a_loop;
  return driveManhattan(town);
}

void printLongDrive(const LongDriveConfig& config,
                    const std::function<void(const std::string&)>& print) {
  const ManhattanWorld world = driveForHours(config);
  const std::vector<Arrival> arrivals = arrivalsOf(world.graph);
  const double before = residentMemory();
  slam::BackEnd back_end(config.back_end);
  print(
      "keyframes,estimated,constraints,mean_ms,median_ms,p99_ms,max_ms,memory_mb,error_m,"
      "stated_m,relative_error_m\n");
  Hour hour;
  for (std::size_t k = 0; k < arrivals.size(); ++k) {
    const CpuTimer timer;
    back_end.addKeyframe(static_cast<graph::NodeId>(k), world.graph.poses[k], arrivals[k].ties);
    back_end.addConstraints(arrivals[k].loops);
    hour.seconds.push_back(timer.seconds());
    addErrors(back_end.graph().poses, world.truth, hour);
    if ((k + 1) % config.keyframes_an_hour == 0 || k + 1 == arrivals.size()) {
      print(rowOf(hour, back_end, residentMemory() - before));
      hour = {};
    }
  }
}

}  // namespace omega_slam::experiments
