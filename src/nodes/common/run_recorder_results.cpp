#include "nodes/common/run_recorder_results.h"

#include <fmt/format.h>

#include "omega_slam/evaluation/map_picture.h"
#include "omega_slam/graph/graph_file.h"
#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/io/trajectory_file.h"

namespace omega_slam {
namespace {

geometry::Trajectory seenFrom(const geometry::Pose2& T_world_map,
                              const geometry::Trajectory& T_world_base) {
  geometry::Trajectory T_map_base = T_world_base;
  for (geometry::StampedPose2& stamped : T_map_base) {
    stamped.pose = geometry::relativePose(T_world_map, stamped.pose);
  }
  return T_map_base;
}

evaluation::MapPicture makePicture(const RunRecord& record, const evaluation::Report& report) {
  evaluation::MapPicture picture;
  picture.map = record.map();
  picture.estimated_path = record.estimate();
  picture.caption = report.input;
  if (report.trajectory_error) {
    picture.true_path = seenFrom(report.trajectory_error->T_truth_map, record.truth());
    picture.caption +=
        fmt::format(": mean error {:.3f} m", report.trajectory_error->translation.mean);
  }
  return picture;
}

}  // namespace

std::vector<std::string> saveResults(const std::filesystem::path& folder, const RunRecord& record,
                                     const evaluation::Report& report,
                                     const std::vector<evaluation::TimingFigures>& timings) {
  std::vector<std::string> faults;
  const auto note = [&faults](const std::string& fault) {
    if (!fault.empty()) {
      faults.push_back(fault);
    }
  };
  if (!record.map().cells.empty()) {
    const grid::SaveResult saved = grid::saveMap(record.map(), folder / "map");
    note(saved.success ? std::string() : saved.message);
    note(evaluation::writeMapPicture(folder / "map.png", makePicture(record, report)));
  }
  note(io::writeTrajectory(folder / "trajectory.tum", record.estimate()));
  note(grid::writeFileAtomically(folder / "graph.g2o", graph::toG2o(record.graph())));
  note(evaluation::writeReport(folder, report, timings));
  return faults;
}

}  // namespace omega_slam
