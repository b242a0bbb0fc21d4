#include "omega_slam/graph/loop_doubt.h"

#include <fmt/format.h>

#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_examination.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {
namespace {

// Each round is solved until it rests: small unrest looks large in a loop that little else ties.
const DescentLimits kRoundLimits{20, 1e-8};

KernelConfig switches() {
  KernelConfig kernels;
  kernels.loop = {KernelKind::kGraduated, 1.0};  // weights as they are set
  return kernels;
}

}  // namespace

// Which loops are near each other, the numbers of the whole graph say.
LoopDoubt::LoopDoubt(const PoseGraph& graph, const RobustConfig& config,
                     const std::vector<bool>& settled)
    : config_(config),
      is_most_settled_(!settled.empty()),
      part_(graph),
      graph_(part_.of(graph)),
      initial_chi_square_(chiSquare(graph_)),
      judgement_(doubtfulLoops(graph, config.support, settled), config),
      weighing_(switches(), graph_) {
  system_.prepare(graph_, spanningForest(graph_).roots);
}

FirstGuess LoopDoubt::guess() const {
  if (is_most_settled_) {
    return FirstGuess::kGiven;
  }
  return rounds_ == 0 ? FirstGuess::kOdometry : FirstGuess::kBest;
}

bool LoopDoubt::advance() {
  if (!goes_on_.value_or(false) || rounds_ >= config_.max_rounds) {
    return false;
  }
  end_ = solveRound(guess(), kRoundLimits);
  ++rounds_;
  goes_on_ = std::nullopt;
  if (end_ != DescentEnd::kSingular && updateFits()) {
    goes_on_ = judgement_.advance();
  }
  return true;
}

DescentEnd LoopDoubt::solveRound(FirstGuess guess, const DescentLimits& limits) {
  PoseGraph believed = believedGraph(graph_, judgement_.loops());
  applyGuess(believed, guess);
  graph_.poses = std::move(believed.poses);
  std::vector<double> weights;
  weights.reserve(judgement_.loops().size());
  for (const DoubtfulLoop& loop : judgement_.loops()) {
    weights.push_back(loop.is_believed ? 1.0 : 0.0);
  }
  weighing_.setStage(weights);
  const DescentAccount account = descendGaussNewton({graph_, system_, weighing_}, limits);
  iterations_ += static_cast<int>(account.chi_squares.size());
  return account.end;
}

bool LoopDoubt::updateFits() {
  const auto fits = examine(graph_, weighing_, system_, weighing_.graduated());
  if (!fits) {
    return false;
  }
  judgement_.hear(*fits, graph_.poses);
  return true;
}

void LoopDoubt::fillReport(RobustReport& report) const {
  SolveReport& solution = report.solution;
  solution.factorizations = system_.factorizations();
  solution.weights.assign(graph_.constraints.size(), 1.0);
  for (const DoubtfulLoop& loop : judgement_.loops()) {
    report.loops.push_back(judgement_.verdictOn(loop));
    report.loops.back().chi_square = chiSquare(graph_, graph_.constraints[loop.constraint]);
    solution.weights[loop.constraint] = report.loops.back().weight;
  }
  solution.chi_square = 0.0;
  for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
    solution.chi_square += solution.weights[k] * chiSquare(graph_, graph_.constraints[k]);
  }
}

/// Solves for what the last round has changed. @return whether Omega allows it
bool LoopDoubt::settle() {
  if (goes_on_ && (*goes_on_ || end_ != DescentEnd::kConverged)) {
    end_ = solveRound(FirstGuess::kGiven, config_.limits);
    return end_ != DescentEnd::kSingular && updateFits();
  }
  return goes_on_.has_value();
}

RobustReport LoopDoubt::finish(PoseGraph& graph) {
  while (advance()) {
  }
  RobustReport report;
  report.rounds = rounds_;
  SolveReport& solution = report.solution;
  solution.initial_chi_square = solution.chi_square = initial_chi_square_;
  if (!settle()) {
    solution.status = SolveStatus::kFailed;
    solution.message =
        "the information matrix is singular: some pose is not determined by the rest";
    return report;
  }
  if (*goes_on_) {
    solution.message = fmt::format("loops are still in doubt after {} rounds", rounds_);
  }
  const bool is_at_rest = end_ == DescentEnd::kConverged && !*goes_on_;
  solution.status = is_at_rest ? SolveStatus::kConverged : SolveStatus::kIterationLimit;
  solution.iterations = iterations_;
  fillReport(report);
  part_.place(graph_.poses, graph);
  return report;
}

}  // namespace omega_slam::graph
