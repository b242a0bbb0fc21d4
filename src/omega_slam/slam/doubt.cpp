#include "omega_slam/slam/doubt.h"

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/linearization.h"

namespace omega_slam::slam {

using geometry::Pose2;
using graph::Constraint;
using graph::PoseGraph;

namespace {

/// Squared error from which on it is in question whether a loop lies where it says.
constexpr double kInQuestion = 9.0;

PoseGraph withLoops(const PoseGraph& graph, const std::vector<Constraint>& withdrawn,
                    std::size_t first) {
  PoseGraph all = graph;
  all.constraints.insert(all.constraints.end(),
                         withdrawn.begin() + static_cast<std::ptrdiff_t>(first), withdrawn.end());
  return all;
}

std::vector<bool> settledOf(const PoseGraph& graph, const LoopSet& confirmed) {
  std::vector<bool> settled;
  for (const Constraint& loop : graph.constraints) {
    settled.push_back(confirmed.count({loop.from, loop.to}) > 0 &&
                      graph::chiSquare(graph, loop) < kInQuestion);
  }
  return settled;
}

/// Later nodes go with the last one that is judged.
void carryOn(const std::vector<Pose2>& before, std::size_t judged, PoseGraph& graph) {
  const Pose2 motion = graph.poses[judged - 1] * before[judged - 1].inverse();
  for (std::size_t i = judged; i < graph.poses.size(); ++i) {
    graph.poses[i] = motion * before[i];
  }
}

}  // namespace

Doubt::Doubt(const PoseGraph& graph, const std::vector<Constraint>& withdrawn, std::size_t first,
             const graph::RobustConfig& config, const std::optional<LoopSet>& confirmed)
    : nodes_(graph.poses.size()),
      tied_(graph.constraints.size()),
      first_(first),
      all_(withLoops(graph, withdrawn, first)),
      rounds_(all_, config, confirmed ? settledOf(all_, *confirmed) : std::vector<bool>{}) {}

std::optional<LoopSet> Doubt::conclude(PoseGraph& graph, std::vector<Constraint>& withdrawn) {
  const std::vector<Pose2> before = graph.poses;
  const graph::RobustReport report = rounds_.finish(graph);
  if (report.solution.status != graph::SolveStatus::kConverged) {
    graph.poses = before;
    return std::nullopt;
  }
  carryOn(before, nodes_, graph);
  LoopSet confirmed;
  std::vector<bool> is_contradicted(all_.constraints.size(), false);
  for (const graph::LoopVerdict& loop : report.loops) {
    is_contradicted[loop.constraint] = loop.standing == graph::LoopStanding::kContradicted;
    if (loop.standing == graph::LoopStanding::kConfirmed) {
      confirmed.emplace(all_.constraints[loop.constraint].from,
                        all_.constraints[loop.constraint].to);
    }
  }
  sortOut(is_contradicted, graph, withdrawn);
  return confirmed;
}

void Doubt::sortOut(const std::vector<bool>& is_contradicted, PoseGraph& graph,
                    std::vector<Constraint>& withdrawn) const {
  std::vector<Constraint> kept;
  std::vector<Constraint> contradicted(withdrawn.begin(),
                                       withdrawn.begin() + static_cast<std::ptrdiff_t>(first_));
  const auto tied = static_cast<std::ptrdiff_t>(tied_);
  for (std::size_t k = 0; k < all_.constraints.size(); ++k) {
    (is_contradicted[k] ? contradicted : kept).push_back(all_.constraints[k]);
  }
  kept.insert(kept.end(), graph.constraints.begin() + tied, graph.constraints.end());
  const std::size_t judged = first_ + all_.constraints.size() - tied_;
  contradicted.insert(contradicted.end(), withdrawn.begin() + static_cast<std::ptrdiff_t>(judged),
                      withdrawn.end());
  graph.constraints = std::move(kept);
  withdrawn = std::move(contradicted);
}

}  // namespace omega_slam::slam
