#include "omega_slam/evaluation/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "omega_slam/evaluation/report_markdown.h"
#include "omega_slam/geometry/pose2.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::evaluation {
namespace {

using Json = nlohmann::json;  // keys in the order of the alphabet

constexpr int kIndent = 2;

std::string text(const Json& json) {
  // Names of files may hold bytes that are not UTF-8: better a replaced letter than no report.
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json statistics(const ErrorStatistics& errors) {
  return {{"mean", errors.mean},
          {"standard_deviation", errors.deviation},
          {"rms", errors.rms()},
          {"mean_square", errors.mean_square},
          {"max", errors.max}};
}

Json scansJson(const ScanFigures& scans) {
  std::size_t rejected = 0;
  for (const auto& [reason, count] : scans.rejections) {
    rejected += count;
  }
  return {{"used", scans.used},
          {"rejected", rejected},
          {"rejections", scans.rejections},
          {"repairs", scans.repairs}};
}

Json loopsJson(const std::vector<LoopFigures>& loops) {
  Json list = Json::array();
  for (const LoopFigures& loop : loops) {
    list.push_back({{"from", loop.from},
                    {"to", loop.to},
                    {"residual_translation", loop.residual_translation},
                    {"residual_rotation", loop.residual_rotation},
                    {"chi_square", loop.chi_square},
                    {"confidence", loop.confidence}});
    if (loop.weight) {
      list.back()["weight"] = *loop.weight;
    }
    if (loop.is_folded) {
      list.back()["folded"] = true;
    }
  }
  return list;
}

Json mapJson(const grid::GridGeometry& map) {
  return {{"resolution", map.resolution},
          {"width", map.width},
          {"height", map.height},
          {"origin", {map.origin.x(), map.origin.y()}}};
}

Json trajectoryJson(const TrajectoryError& error) {
  return {{"matched", error.matched},
          {"unmatched", error.unmatched},
          {"T_truth_map", {error.T_truth_map.x, error.T_truth_map.y, error.T_truth_map.theta}},
          {"translation", statistics(error.translation)},
          {"rotation", statistics(error.rotation)}};
}

Json relationsJson(const RelationsScore& score) {
  return {{"relations", score.relations},
          {"covered", score.covered},
          {"translation", statistics(score.translation)},
          {"rotation", statistics(score.rotation)}};
}

Json resemblanceJson(const Resemblance& map) {
  return {{"score", map.score()},
          {"balanced", map.balanced()},
          {"walls",
           {{"right", map.walls_right},
            {"wrong", map.walls_wrong},
            {"precision", map.wallPrecision()},
            {"recall", map.wallRecall()}}},
          {"open",
           {{"right", map.open_right},
            {"wrong", map.open_wrong},
            {"precision", map.openPrecision()},
            {"recall", map.openRecall()}}},
          {"coverage", map.coverage()}};
}

/// Value at a share of the sorted values, by the nearest rank.
double quantile(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

LoopFigures figuresOf(const graph::PoseGraph& graph, const graph::Constraint& loop) {
  const geometry::Pose2 believed =
      geometry::relativePose(graph.poses.at(loop.from), graph.poses.at(loop.to));
  const Eigen::Vector3d residual = geometry::relativePose(loop.T_from_to, believed).vector();
  return {loop.from,
          loop.to,
          residual.head<2>().norm(),
          std::abs(residual.z()),
          residual.dot(loop.information * residual),
          loop.confidence};
}

}  // namespace

std::vector<LoopFigures> loopFigures(const graph::PoseGraph& graph,
                                     const std::vector<double>& weights,
                                     const std::vector<graph::Constraint>& withdrawn,
                                     const std::vector<graph::Constraint>& folded) {
  std::vector<LoopFigures> figures;
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    if (graph.constraints[k].kind == graph::ConstraintKind::kLoop) {
      figures.push_back(figuresOf(graph, graph.constraints[k]));
      if (!weights.empty()) {
        figures.back().weight = weights.at(k);
      }
    }
  }
  for (const graph::Constraint& loop : withdrawn) {
    figures.push_back(figuresOf(graph, loop));
    figures.back().weight = 0.0;
  }
  for (const graph::Constraint& loop : folded) {
    figures.push_back(figuresOf(graph, loop));
    figures.back().is_folded = true;
  }
  return figures;
}

double pathLength(const geometry::Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t k = 1; k < trajectory.size(); ++k) {
    length += geometry::distance(trajectory[k - 1].pose, trajectory[k].pose);
  }
  return length;
}

TimingFigures summarizeTimes(const std::string& name, std::vector<double> seconds) {
  TimingFigures figures;
  figures.name = name;
  figures.count = seconds.size();
  if (seconds.empty()) {
    return figures;
  }
  std::sort(seconds.begin(), seconds.end());
  for (const double time : seconds) {
    figures.total += time;
  }
  figures.median = quantile(seconds, 0.5);
  figures.percentile_99 = quantile(seconds, 0.99);
  figures.max = seconds.back();
  return figures;
}

std::string toJson(const Report& report) {
  Json json;
  json["format"] = 1;
  json["input"] = report.input;
  const auto put = [&json](const char* key, const auto& value, const auto& convert) {
    if (value) {
      json[key] = convert(*value);
    }
  };
  const auto plain = [](const auto& value) { return Json(value); };
  put("duration", report.duration, plain);
  put("distance", report.distance, plain);
  put("scans", report.scans, scansJson);
  put("keyframes", report.keyframes, plain);
  put("loops", report.loops, loopsJson);
  put("chi_square", report.chi_square, plain);
  put("map", report.map, mapJson);
  put("absolute_trajectory_error", report.trajectory_error, trajectoryJson);
  put("relations", report.relations, relationsJson);
  put("resemblance", report.resemblance, resemblanceJson);
  if (!report.notes.empty()) {
    json["notes"] = report.notes;
  }
  return text(json);
}

std::string toJson(const std::vector<TimingFigures>& timings) {
  Json json;
  json["format"] = 1;
  json["timings"] = Json::object();
  for (const TimingFigures& timing : timings) {
    json["timings"][timing.name] = {{"count", timing.count},
                                    {"total", timing.total},
                                    {"median", timing.median},
                                    {"percentile_99", timing.percentile_99},
                                    {"max", timing.max}};
  }
  return text(json);
}

std::string toMarkdown(const Report& report) { return detail::reportAsMarkdown(report); }

std::string writeReport(const std::filesystem::path& folder, const Report& report,
                        const std::vector<TimingFigures>& timings) {
  std::string faults;
  const auto write = [&](const char* name, const std::string& content) {
    const std::string fault = grid::writeFileAtomically(folder / name, content);
    faults += faults.empty() || fault.empty() ? fault : " " + fault;
  };
  write("report.json", toJson(report));
  write("report.md", toMarkdown(report));
  write("timing.json", toJson(timings));
  return faults;
}

}  // namespace omega_slam::evaluation
