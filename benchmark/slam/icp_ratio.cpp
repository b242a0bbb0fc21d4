#include "slam/icp_ratio.h"

#include <fmt/format.h>

#include "experiments/cpu_timer.h"
#include "experiments/peers.h"
#include "omega_slam/slam/keyframe.h"
#include "slam/slam_run.h"

namespace omega_slam::experiments {

std::string icpRatioTable(const Recording& recording, const slam::PipelineConfig& config) {
  const SlamRun run = runSlam(recording.records, config);
  const PclIcp icp;
  std::size_t matches = 0;
  double icp_seconds = 0.0;
  for (std::size_t k = 1; k < run.keyframes.size(); ++k) {
    const slam::Keyframe& before = *run.keyframes[k - 1];
    const slam::Keyframe& after = *run.keyframes[k];
    const matching::Reference reference{slam::viewOf(before.sweep)};
    const matching::View scan = slam::viewOf(after.sweep);
    const CpuTimer timer;
    (void)icp.match(reference, scan, relativePose(before.T_odom_base, after.T_odom_base));
    icp_seconds += timer.seconds();
    ++matches;
  }
  const double scan_ms = 1e3 * run.cpu_seconds / static_cast<double>(run.seconds.size());
  const double icp_ms = 1e3 * icp_seconds / static_cast<double>(matches);
  return fmt::format("log,scans,scan_ms,icp_matches,icp_ms,ratio\n{},{},{:.5g},{},{:.5g},{:.4g}\n",
                     recording.name, run.seconds.size(), scan_ms, matches, icp_ms,
                     scan_ms / icp_ms);
}

}  // namespace omega_slam::experiments
