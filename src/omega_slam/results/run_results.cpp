#include "omega_slam/results/run_results.h"

#include "omega_slam/evaluation/map_picture.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/io/trajectory_file.h"

namespace omega_slam::results {

std::vector<std::string> writeResults(const std::filesystem::path& folder,
                                      const RunResults& results) {
  std::vector<std::string> faults;
  const auto note = [&](const std::string& fault) {
    if (!fault.empty()) {
      faults.push_back(fault);
    }
  };
  if (results.map.geometry.size() > 0) {
    const grid::SaveResult saved = grid::saveMap(results.map, folder / "map");
    note(saved.success ? "" : saved.message);
    note(evaluation::writeMapPicture(
        folder / "map.png", {results.map, results.estimate, results.truth, results.report.input}));
  }
  note(io::writeTrajectory(folder / "trajectory.tum", results.estimate));
  note(grid::writeFileAtomically(folder / "graph.g2o", graph::toG2o(results.graph)));
  note(evaluation::writeReport(folder, results.report, results.timings));
  return faults;
}

}  // namespace omega_slam::results
