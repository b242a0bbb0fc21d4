#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cmath>

#include "experiments/cpu_timer.h"
#include "maps/standing_scans.h"
#include "omega_slam/evaluation/cell_mask.h"

namespace omega_slam::experiments {
namespace {

mrpt::poses::CPose3D toMrpt(const geometry::Pose2& pose) {
  return {pose.x, pose.y, 0.0, pose.theta, 0.0, 0.0};
}

mrpt::obs::CObservation2DRangeScan toMrpt(const sensing::LaserScan& scan,
                                          const sensing::LaserMount& mount) {
  mrpt::obs::CObservation2DRangeScan observation;
  observation.rightToLeft = true;
  observation.aperture =
      static_cast<float>(scan.angle_increment * static_cast<double>(scan.ranges.size() - 1));
  observation.maxRange = static_cast<float>(scan.range_max);
  observation.sensorPose = toMrpt(mount.T_base_laser);
  observation.resizeScan(scan.ranges.size());
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const bool is_return = std::isfinite(scan.ranges[beam]);
    observation.setScanRange(beam,
                             is_return ? scan.ranges[beam] : static_cast<float>(scan.range_max));
    observation.setScanRangeValidity(beam, is_return);
  }
  return observation;
}

/// MRPT has the probability that a cell is free, one half where nothing is known.
std::int8_t verdict(float free) {
  constexpr float kUndecided = 0.02F;
  if (std::abs(free - 0.5F) < kUndecided) {
    return grid::kUnknown;
  }
  return free > 0.5F ? grid::kFree : grid::kOccupied;
}

}  // namespace

std::optional<TimedMap> drawByMrpt(const std::vector<StandingScan>& scans,
                                   const sensing::LaserMount& mount,
                                   const grid::GridGeometry& area) {
  const Eigen::Vector2d far_corner =
      area.origin + area.resolution * Eigen::Vector2d(area.width, area.height);
  mrpt::maps::COccupancyGridMap2D map(
      static_cast<float>(area.origin.x()), static_cast<float>(far_corner.x()),
      static_cast<float>(area.origin.y()), static_cast<float>(far_corner.y()),
      static_cast<float>(area.resolution));
  // As our intake takes it by default: a beam without a return says nothing.
  map.insertionOptions.considerInvalidRangesAsFreeSpace = false;
  std::vector<mrpt::obs::CObservation2DRangeScan> observations;
  for (const StandingScan& taken : scans) {
    observations.push_back(toMrpt(taken.scan, mount));
  }
  TimedMap result;
  const CpuTimer timer;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    map.insertObservation(observations[k], toMrpt(scans[k].T_map_base));
  }
  result.seconds = timer.seconds();
  result.map = grid::makeGrid(area, grid::kUnknown);
  evaluation::forEachCell(area, [&](const grid::Cell& cell) {
    const Eigen::Vector2d center = area.center(cell);
    result.map.at(cell) =
        verdict(map.getPos(static_cast<float>(center.x()), static_cast<float>(center.y())));
  });
  return result;
}

}  // namespace omega_slam::experiments
