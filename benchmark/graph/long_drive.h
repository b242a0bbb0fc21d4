#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "graph/manhattan_world.h"
#include "omega_slam/slam/back_end.h"

namespace omega_slam::experiments {

/// A robot that drives about in the same few streets for hours.
struct LongDriveConfig {
  std::size_t keyframes{40000};
  std::size_t keyframes_an_hour{4000};  ///< of which there is a row each
  std::size_t crossings{25};            ///< of the town
  int returns_a_loop{3};                ///< as ManhattanConfig
  slam::BackEndConfig back_end;
};

/// The town and the drive through it.
[[nodiscard]] ManhattanWorld driveForHours(const LongDriveConfig& config);

/// Plays the drive to slam::BackEnd, keyframe by keyframe, as `graph_slam` does, and prints a table
/// (CSV): a row for each hour, with the size of the graph after it, the processor time of its
/// updates (one is of a keyframe and the loops that come with it), the memory that the process
/// holds beyond that of the drive itself, and how far keyframes were from the truth when they came,
/// in the mean: seen from the first keyframe, beside the deviation that the graph states at the
/// end of the hour, and seen from the one 500 before.
void printLongDrive(const LongDriveConfig& config,
                    const std::function<void(const std::string&)>& print);

}  // namespace omega_slam::experiments
