#include "omega_slam/mapping/map_update.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::mapping {
namespace {

constexpr double kCellShare = 0.5;  // of a cell, that the end of a beam may be off

/// Whether a sweep is drawn well enough where it is.
bool stands(const DrawnSweep& drawn, const PlacedSweep& now, double tolerance) {
  const geometry::Pose2& before = drawn.placed.T_map_base;
  if (drawn.placed.sweep != now.sweep) {
    return false;
  }
  // Below the tolerance by far, as nearly all are, no root and no angle needs to be found.
  const double bound = std::abs(now.T_map_base.x - before.x) +
                       std::abs(now.T_map_base.y - before.y) +
                       std::abs(now.T_map_base.theta - before.theta) * drawn.reach;
  if (bound <= tolerance) {
    return true;
  }
  const double turn = std::abs(geometry::angleDifference(now.T_map_base.theta, before.theta));
  return geometry::distance(before, now.T_map_base) + turn * drawn.reach <= tolerance;
}

/// What is to be done to a map.
struct Work {
  std::vector<SweepId> gone;
  std::vector<const PlacedSweep*> moved;
  std::vector<const PlacedSweep*> fresh;
};

Work compare(const OccupancyMapper& mapper, const std::vector<PlacedSweep>& sweeps) {
  const double tolerance = kCellShare * mapper.config().resolution;
  Work work;
  auto drawn = mapper.drawn().begin();
  const auto end = mapper.drawn().end();
  for (const PlacedSweep& sweep : sweeps) {
    for (; drawn != end && drawn->placed.id < sweep.id; ++drawn) {
      work.gone.push_back(drawn->placed.id);
    }
    if (drawn == end || drawn->placed.id != sweep.id) {
      work.fresh.push_back(&sweep);
      continue;
    }
    if (!stands(*drawn, sweep, tolerance)) {
      work.moved.push_back(&sweep);
    }
    ++drawn;
  }
  for (; drawn != end; ++drawn) {
    work.gone.push_back(drawn->placed.id);
  }
  return work;
}

}  // namespace

UpdateReport update(OccupancyMapper& mapper, const std::vector<PlacedSweep>& sweeps) {
  const Work work = compare(mapper, sweeps);
  UpdateReport report;
  report.removed = work.gone.size();
  const auto put = [&](const PlacedSweep& sweep, std::size_t& count) {
    if (std::string reason = mapper.put(sweep); !reason.empty()) {
      report.refusals.push_back(std::move(reason));
    } else {
      ++count;
    }
  };
  if (2 * (work.gone.size() + work.moved.size()) > mapper.drawn().size()) {
    mapper.clear();
    report.is_redrawn = true;
    for (const PlacedSweep& sweep : sweeps) {
      put(sweep, report.drawn);
    }
    return report;
  }
  std::for_each(work.gone.begin(), work.gone.end(), [&](SweepId id) { mapper.takeOut(id); });
  for (const auto* sweeps_to_put : {&work.moved, &work.fresh}) {
    for (const PlacedSweep* sweep : *sweeps_to_put) {
      put(*sweep, report.drawn);
    }
  }
  report.moved = work.moved.size();
  return report;
}

}  // namespace omega_slam::mapping
