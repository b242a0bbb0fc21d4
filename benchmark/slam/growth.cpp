#include "slam/growth.h"

#include <fmt/format.h>

#include <vector>

#include "experiments/resident_memory.h"
#include "omega_slam/evaluation/report.h"
#include "slam/slam_run.h"

namespace omega_slam::experiments {
namespace {

double residentMegabytes() { return residentMemory() / (1024.0 * 1024.0); }

}  // namespace

Records drivenOver(const Records& log, int passes) {
  Records whole = log;
  whole.reserve(log.size() * static_cast<std::size_t>(passes));
  for (int pass = 1; pass < passes; ++pass) {
    // Where the last scan of a pass was taken, the next pass begins; not with that scan again.
    for (std::size_t k = 1; k < log.size(); ++k) {
      const bool is_back = pass % 2 == 1;
      const std::size_t from = is_back ? log.size() - k : k - 1;
      const std::size_t to = is_back ? from - 1 : k;
      io::ScanRecord record = log[to];
      const double wait = log[to].scan.stamp - log[from].scan.stamp;
      record.scan.stamp = whole.back().scan.stamp + (is_back ? -wait : wait);
      whole.push_back(std::move(record));
    }
  }
  return whole;
}

std::string growthTable(const std::string& name, const Records& log, int passes,
                        const slam::PipelineConfig& config, std::size_t scans_a_row) {
  std::string table =
      "log,scans,passes,keyframes,constraints,mean_ms,p99_ms,max_ms,cpu_seconds,memory_mb\n";
  const Records whole = drivenOver(log, passes);
  const double before = residentMegabytes();
  std::vector<double> seconds;
  std::size_t scans = 0;
  double sum = 0.0;
  (void)runSlam(whole, config, [&](const slam::Pipeline& pipeline, double took) {
    seconds.push_back(took);
    sum += took;
    if (++scans % scans_a_row == 0) {
      const auto times = evaluation::summarizeTimes("scan", seconds);
      const auto count = static_cast<double>(seconds.size());
      table += fmt::format("{},{},{:.3f},{},{},{:.4g},{:.4g},{:.4g},{:.5g},{:.1f}\n", name, scans,
                           static_cast<double>(scans) / static_cast<double>(log.size()),
                           pipeline.keyframes().size(), pipeline.graph().constraints.size(),
                           1e3 * times.total / count, 1e3 * times.percentile_99, 1e3 * times.max,
                           sum, residentMegabytes() - before);
      seconds.clear();
    }
  });
  return table;
}

}  // namespace omega_slam::experiments
