#pragma once

#include <optional>
#include <string>
#include <vector>

#include "omega_slam/navigation/costmap.h"
#include "omega_slam/navigation/path.h"

namespace omega_slam::navigation {

/// The planners of OMPL that can be asked for by name.
[[nodiscard]] const std::vector<std::string>& samplingPlannerNames();

struct SamplingLimits {
  int iterations{2000};  ///< of the planner's own loop, after which it ends: the same in every run
  double time{0.2};      ///< [s] of wall time, after which it ends in any case
  int seed{1};           ///< above 0
};

/// A path between the ends of another one, by a planner of OMPL: around the other path, and as
/// cheap as it finds. OMPL draws its seeds from a generator of the whole process, so that runs
/// repeat only where one thread at a time plans.
/// @param name one of samplingPlannerNames()
/// @return none if it has not found one within its limits
[[nodiscard]] std::optional<Path> samplePath(const std::string& name, const Costmap& costmap,
                                             const ClearanceCost& cost, const Path& around,
                                             const SamplingLimits& limits);

}  // namespace omega_slam::navigation
