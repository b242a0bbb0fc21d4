#include "slam/walls.h"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>
#include <vector>

#include "omega_slam/evaluation/map_picture.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/keyframe.h"
#include "slam/crispness.h"
#include "slam/gmapping_path.h"
#include "slam/slam_run.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

/// Draws the scans and judges their walls. @return a row of the table
std::string judge(const std::string& name, const std::string& who,
                  const std::vector<sensing::Sweep>& sweeps, const std::vector<Pose2>& poses,
                  const std::filesystem::path& folder) {
  mapping::OccupancyMapper mapper;
  std::vector<matching::View> views;
  for (std::size_t k = 0; k < sweeps.size(); ++k) {
    mapper.add(sweeps[k], poses[k]);
    views.push_back(slam::viewOf(sweeps[k]));
  }
  const std::string fault = evaluation::writeMapPicture(folder / (name + '_' + who + ".png"),
                                                        {mapper.render(), {}, {}, who});
  if (!fault.empty()) {
    throw std::runtime_error(fault);
  }
  const Crispness crispness = judgeCrispness(views, poses);
  return fmt::format("{},{},{},{:.5g},{:.5g}\n", name, who, sweeps.size(), crispness.wall_distance,
                     crispness.entropy);
}

}  // namespace

std::string compareWalls(const Recording& recording, const slam::PipelineConfig& config,
                         const std::filesystem::path& corrected,
                         const std::filesystem::path& folder) {
  const SlamRun run = runSlam(recording.records, config);
  CorrectedScans chosen;
  if (corrected.empty()) {
    chosen.scans.resize(recording.records.size());
    std::iota(chosen.scans.begin(), chosen.scans.end(), std::size_t{0});
  } else {
    chosen = readCorrectedScans(corrected, recording.records);
  }
  const sensing::ScanIntake intake(config.intake);
  std::vector<sensing::Sweep> sweeps;
  std::vector<Pose2> ours;
  std::vector<Pose2> theirs;
  for (std::size_t k = 0; k < chosen.scans.size(); ++k) {
    const io::ScanRecord& record = recording.records[chosen.scans[k]];
    const auto sweep = intake.process(record.scan, record.mount, record.motion_during_sweep).sweep;
    if (sweep) {
      sweeps.push_back(*sweep);
      ours.push_back(run.trajectory.at(chosen.scans[k]).pose);
      theirs.push_back(corrected.empty() ? Pose2{} : chosen.poses[k]);
    }
  }
  std::string table = "log,who,scans,wall_distance,entropy\n";
  table += judge(recording.name, "omega_slam", sweeps, ours, folder);
  if (!corrected.empty()) {
    table += judge(recording.name, "gmapping", sweeps, theirs, folder);
  }
  return table;
}

}  // namespace omega_slam::experiments
