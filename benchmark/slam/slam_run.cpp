#include "slam/slam_run.h"

#include "experiments/cpu_timer.h"

namespace omega_slam::experiments {

SlamRun runSlam(const std::vector<io::ScanRecord>& records, const slam::PipelineConfig& config,
                const ScanWatcher& watcher) {
  SlamRun run;
  slam::Pipeline pipeline(config);
  for (const io::ScanRecord& record : records) {
    const CpuTimer timer;
    const slam::ScanOutcome outcome =
        pipeline.process(record.scan, record.mount, record.T_odom_base, record.motion_during_sweep);
    run.seconds.push_back(timer.seconds());
    run.cpu_seconds += run.seconds.back();
    run.rejected += outcome.rejection.empty() ? 0 : 1;
    if (watcher) {
      watcher(pipeline, run.seconds.back());
    }
  }
  const CpuTimer timer;
  run.weights = pipeline.finish().weights;
  run.trajectory = pipeline.trajectory();
  run.map = pipeline.map({});
  run.cpu_seconds += timer.seconds();
  run.keyframes = pipeline.keyframes();
  run.graph = pipeline.graph();
  run.withdrawn_loops = pipeline.withdrawnLoops();
  run.folded_loops = pipeline.foldedLoops();
  return run;
}

}  // namespace omega_slam::experiments
