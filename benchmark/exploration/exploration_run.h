#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "exploration/coverage.h"
#include "exploration/localisation.h"
#include "omega_slam/exploration/explorer.h"
#include "omega_slam/navigation/footprint.h"
#include "omega_slam/simulation/world.h"

namespace omega_slam::experiments {

struct RunSetup {
  std::shared_ptr<const simulation::World> world;
  const Seeable* seeable{nullptr};
  geometry::Pose2 T_world_start;
  navigation::Footprint footprint;
  exploration::ExplorerConfig explorer;
  std::uint64_t seed{1};
  double patience{3600.0};  ///< [s] of simulated time, after which the run is cut off
  LocalisationKind localisation{LocalisationKind::kSlam};
};

/// How far a run had come at a time.
struct RunSample {
  double time{0.0};      ///< [s] simulated, since the start
  double distance{0.0};  ///< [m] truly driven
  double coverage{0.0};  ///< [0, 1] of what can be seen
};

/// What became of a goal.
struct RunGoal {
  double time{0.0};  ///< [s] when it was given
  geometry::Pose2 T_map_base;
  double size{0.0};  ///< [m] of its frontier; 0: none
  std::string fate;  ///< "reached", "dropped" for a better one, or why it was not reached
};

/// Where a run's time goes [s].
struct RunTimes {
  double driving{0.0};
  double turning{0.0};     ///< on the spot
  double recovering{0.0};  ///< from trouble
  double standing{0.0};    ///< without a goal, or waiting
};

/// A collision.
struct RunContact {
  double time{0.0};  ///< [s]
  geometry::Pose2 T_world_base;
  bool unseen{false};  ///< with glass or with what is dark
};

struct RunOutcome {
  bool ended{false};  ///< by itself
  exploration::Ending ending{exploration::Ending::kNone};
  std::string reason;
  RunSample end;                     ///< when the robot was home
  double explored_time{0.0};         ///< [s] when exploring was over and the way home began
  double explored_distance{0.0};     ///< [m] likewise
  double from_home{0.0};             ///< [m] of the robot at the end, in truth
  std::vector<RunContact> contacts;  ///< collisions, one after the other
  std::vector<RunGoal> goals;
  RunTimes times;
  double explorer_cpu{0.0};   ///< [s]
  double navigator_cpu{0.0};  ///< [s]
  std::vector<RunSample> samples;
  std::vector<Eigen::Vector2d> path;  ///< [m] true, in the world
  grid::OccupancyGrid map;
};

/// One exploration in one process: simulator, localisation, map, Explorer and Navigator with the
/// defaults of their configurations, at fixed time steps. Same setup, same outcome.
[[nodiscard]] RunOutcome explore(const RunSetup& setup);

}  // namespace omega_slam::experiments
