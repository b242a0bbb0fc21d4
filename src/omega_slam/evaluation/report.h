#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/evaluation/resemblance.h"
#include "omega_slam/evaluation/trajectory_error.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/grid/grid_geometry.h"

namespace omega_slam::evaluation {

/// One loop of the graph and how far it is from being met.
struct LoopFigures {
  graph::NodeId from{0};
  graph::NodeId to{0};
  double residual_translation{0.0};  ///< [m]
  double residual_rotation{0.0};     ///< [rad], absolute
  double chi_square{0.0};
  double confidence{0.0};
  std::optional<double> weight{};  ///< with which it counts: 0 if it was withdrawn
  bool is_folded{false};           ///< it counts in other constraints: it has no weight of its own
};

/// The loops of a graph in their order, measured at its poses, and then those withdrawn from it and
/// those folded into other constraints.
/// @param weights of all constraints, as graph::SolveReport has them; empty if nobody knows
[[nodiscard]] std::vector<LoopFigures> loopFigures(
    const graph::PoseGraph& graph, const std::vector<double>& weights = {},
    const std::vector<graph::Constraint>& withdrawn = {},
    const std::vector<graph::Constraint>& folded = {});

/// Length of a path [m].
[[nodiscard]] double pathLength(const geometry::Trajectory& trajectory);

/// What became of the scans of a run.
struct ScanFigures {
  std::size_t used{0};                            ///< went on to SLAM, mended or not
  std::map<std::string, std::size_t> repairs;     ///< how often each repair was made
  std::map<std::string, std::size_t> rejections;  ///< how many were rejected, by reason
};

/// All that is to be said of a run, the time it took aside: that is never the same twice. What is
/// not known is left empty and then left out of the report.
struct Report {
  std::string input;               ///< such as the name of the log or of the world
  std::optional<double> duration;  ///< [s] covered by the input
  std::optional<double> distance;  ///< [m] driven, along the estimate
  std::optional<ScanFigures> scans;
  std::optional<std::size_t> keyframes;
  std::optional<std::vector<LoopFigures>> loops;
  std::optional<double> chi_square;  ///< of the whole graph
  std::optional<grid::GridGeometry> map;
  std::optional<TrajectoryError> trajectory_error;
  std::optional<RelationsScore> relations;
  std::optional<Resemblance> resemblance;
  std::vector<std::string> notes;  ///< sentences for the reader
};

/// How long something took, over many times [s].
struct TimingFigures {
  std::string name;
  std::size_t count{0};
  double total{0.0};
  double median{0.0};
  double percentile_99{0.0};
  double max{0.0};
};

[[nodiscard]] TimingFigures summarizeTimes(const std::string& name, std::vector<double> seconds);

[[nodiscard]] std::string toJson(const Report& report);      ///< SI units and radians
[[nodiscard]] std::string toMarkdown(const Report& report);  ///< for people; angles in degrees
[[nodiscard]] std::string toJson(const std::vector<TimingFigures>& timings);

/// Writes report.json, report.md and timing.json into a folder, each atomically. The first two are
/// the same, byte by byte, for the same report.
/// @return an empty string, or one sentence for each file that could not be written
[[nodiscard]] std::string writeReport(const std::filesystem::path& folder, const Report& report,
                                      const std::vector<TimingFigures>& timings);

}  // namespace omega_slam::evaluation
