#include "omega_slam/graph/robust_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_consistency.h"
#include "omega_slam/graph/loop_examination.h"
#include "omega_slam/graph/loop_fit.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {
namespace {

constexpr double kAgreementGate = 4.0;   // [standard deviations] of the cycle through two loops
constexpr double kReluctance = 10.0;     // a loop that is believed may look so much more accidental
constexpr int kPatience = 2;             // a loop that was withdrawn so often has no further chance
constexpr double kLikelySquared = 11.3;  // 99 % of chi-square with 3 degrees of freedom
constexpr double kMedianSquared = 2.37;  // 50 %
constexpr std::size_t kSample = 20;      // loops from which the scale of covariances can be told
constexpr double kHeavyTail = 4.0;       // by which a variance so found is widened
constexpr double kFairOdds = 1.0;
constexpr double kFirstShare = 1e-4;  // of the chance allowed; all of it some rounds later
constexpr double kShareGrowth = 10.0;
const DescentLimits kRoundLimits{20, 1e-4};

KernelConfig switches() {
  KernelConfig kernels;
  kernels.loop = {KernelKind::kGraduated, 1.0};  // weights as they are set
  return kernels;
}

/// Which nodes hang together.
class Parts {
 public:
  explicit Parts(std::size_t nodes) : parents_(nodes) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  /// @return whether they were apart
  bool unite(std::size_t a, std::size_t b) {
    const std::size_t root_a = rootOf(a);
    const std::size_t root_b = rootOf(b);
    parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    return root_a != root_b;
  }

 private:
  std::size_t rootOf(std::size_t node) {
    while (parents_[node] != node) {
      node = parents_[node] = parents_[parents_[node]];
    }
    return node;
  }

  std::vector<std::size_t> parents_;
};

/// What is known of a loop while the rounds go on.
struct Doubtful {
  std::size_t constraint{0};
  std::vector<std::size_t> supporters;  ///< indices of doubtful loops
  bool is_believed{false};
  bool is_presumed{false};  ///< believed for want of better
  bool is_tie{false};       ///< believed for ever
  int withdrawals{0};
  LoopFit fit;
};

class Examination {
 public:
  Examination(PoseGraph& graph, const RobustConfig& config);

  [[nodiscard]] RobustReport run();

 private:
  void findLoops();
  void findTies();
  [[nodiscard]] PoseGraph believedGraph() const;
  [[nodiscard]] DescentEnd solveRound(FirstGuess guess, const DescentLimits& limits);
  [[nodiscard]] bool updateFits();
  [[nodiscard]] double limitOf(const Doubtful& loop) const;
  bool withdrawWorst();
  bool believeConfirmed();
  bool presumeLikeliest();
  bool reopen();
  [[nodiscard]] double varianceFactor() const;
  [[nodiscard]] LoopVerdict verdictOn(const Doubtful& loop) const;
  void fillReport(RobustReport& report) const;

  PoseGraph& graph_;
  const RobustConfig& config_;
  std::vector<Doubtful> loops_;
  Weighing weighing_;
  GraphSystem system_;
  ErrorSpace space_;
  double share_{kFirstShare};  ///< of the chance allowed
};

Examination::Examination(PoseGraph& graph, const RobustConfig& config)
    : graph_(graph), config_(config), weighing_(switches(), graph) {
  findLoops();
  findTies();
  system_.prepare(graph_, spanningForest(graph_).roots);
}

void Examination::findLoops() {
  const auto& indices = weighing_.graduated();
  const auto agreeing = agreeingLoops(graph_, indices, config_.neighbourhood, kAgreementGate);
  loops_.resize(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    loops_[i].constraint = indices[i];
    loops_[i].supporters = agreeing[i];
  }
}

/// Loops without which a part of the graph would hang on nothing: those with most support.
void Examination::findTies() {
  Parts parts(graph_.poses.size());
  for (const Constraint& constraint : graph_.constraints) {
    if (constraint.kind != ConstraintKind::kLoop) {
      parts.unite(constraint.from, constraint.to);
    }
  }
  for (const NodeId node : graph_.held) {
    parts.unite(graph_.held.front(), node);
  }
  std::vector<std::size_t> order(loops_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) {
    return loops_[i].supporters.size() > loops_[j].supporters.size();
  });
  for (const std::size_t i : order) {
    const Constraint& constraint = graph_.constraints[loops_[i].constraint];
    if (parts.unite(constraint.from, constraint.to)) {
      loops_[i].is_tie = loops_[i].is_believed = true;
    }
  }
}

PoseGraph Examination::believedGraph() const {
  PoseGraph believed{graph_.poses, {}, graph_.held, graph_.points};
  auto loop = loops_.begin();
  for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
    const bool is_loop = loop != loops_.end() && loop->constraint == k;
    if (!is_loop || loop->is_believed) {
      believed.constraints.push_back(graph_.constraints[k]);
    }
    loop += is_loop ? 1 : 0;
  }
  return believed;
}

DescentEnd Examination::solveRound(FirstGuess guess, const DescentLimits& limits) {
  PoseGraph believed = believedGraph();
  applyGuess(believed, guess);
  graph_.poses = std::move(believed.poses);
  std::vector<double> weights;
  weights.reserve(loops_.size());
  for (const Doubtful& loop : loops_) {
    weights.push_back(loop.is_believed ? 1.0 : 0.0);
  }
  weighing_.setStage(weights);
  return descendGaussNewton({graph_, system_, weighing_}, limits).end;
}

bool Examination::updateFits() {
  const auto fits = examine(graph_, weighing_, system_, weighing_.graduated());
  if (!fits) {
    return false;
  }
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    loops_[i].fit = (*fits)[i];
  }
  space_ = ErrorSpace::of(graph_.poses);
  return true;
}

/// Chance up to which a loop's fit is no accident.
double Examination::limitOf(const Doubtful& loop) const {
  const double alone = config_.accidents / static_cast<double>(loops_.size());
  return loop.supporters.empty() ? alone : std::max(alone, config_.supported_chance);
}

bool Examination::withdrawWorst() {
  Doubtful* worst = nullptr;
  double most = 1.0;
  for (Doubtful& loop : loops_) {
    if (!loop.is_believed || loop.is_tie || !loop.fit.is_testable) {
      continue;
    }
    double excess = loop.fit.squared / (config_.gate * config_.gate);
    if (!loop.is_presumed) {
      excess = std::max(excess, chanceOf(loop.fit, space_) / (kReluctance * limitOf(loop)));
    }
    if (excess > most) {
      most = excess;
      worst = &loop;
    }
  }
  if (worst == nullptr) {
    return false;
  }
  worst->is_believed = worst->is_presumed = false;
  ++worst->withdrawals;
  return true;
}

bool Examination::believeConfirmed() {
  bool is_any = false;
  for (Doubtful& loop : loops_) {
    if (!loop.is_believed && loop.withdrawals < kPatience &&
        loop.fit.squared < config_.gate * config_.gate &&
        chanceOf(loop.fit, space_) < share_ * limitOf(loop)) {
      loop.is_believed = is_any = true;
    }
  }
  return is_any;
}

/// A last chance for what was withdrawn while much was wrong.
bool Examination::reopen() {
  for (Doubtful& loop : loops_) {
    loop.withdrawals = std::min(loop.withdrawals, kPatience - 1);
  }
  return believeConfirmed();
}

/// By how much covariances are too large, seen from the loops that are believed: 1 if they are not.
double Examination::varianceFactor() const {
  std::vector<double> squared;
  for (const Doubtful& loop : loops_) {
    if (loop.is_believed && loop.fit.is_testable) {
      squared.push_back(loop.fit.squared);
    }
  }
  if (squared.size() < kSample) {
    return 1.0;
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::clamp(kHeavyTail * *middle / kMedianSquared, 1e-6, 1.0);
}

bool Examination::presumeLikeliest() {
  const double variance = varianceFactor();
  const auto mayBe = [&](const Doubtful& loop) {
    return !loop.is_believed && loop.withdrawals < kPatience &&
           loop.fit.squared < kLikelySquared * variance;
  };
  Doubtful* likeliest = nullptr;
  std::pair<bool, double> best{false, 0.0};
  for (Doubtful& loop : loops_) {
    const std::pair<bool, double> rank{!loop.supporters.empty(),
                                       oddsOf(loop.fit, space_, variance)};
    if (mayBe(loop) && rank.second > kFairOdds && rank > best) {
      best = rank;
      likeliest = &loop;
    }
  }
  if (likeliest == nullptr) {
    return false;
  }
  likeliest->is_believed = likeliest->is_presumed = true;
  for (const std::size_t i : likeliest->supporters) {
    if (mayBe(loops_[i])) {
      loops_[i].is_believed = loops_[i].is_presumed = true;
    }
  }
  return true;
}

LoopVerdict Examination::verdictOn(const Doubtful& loop) const {
  LoopVerdict verdict;
  verdict.constraint = loop.constraint;
  verdict.weight = loop.is_believed ? 1.0 : 0.0;
  verdict.chi_square = chiSquare(graph_, graph_.constraints[loop.constraint]);
  verdict.squared = loop.fit.squared;
  verdict.chance = chanceOf(loop.fit, space_);
  verdict.supporters = loop.supporters.size();
  if (loop.is_tie) {
    verdict.standing = LoopStanding::kOnlyTie;
  } else if (loop.is_believed) {
    verdict.standing = verdict.chance < kReluctance * limitOf(loop) ? LoopStanding::kConfirmed
                                                                    : LoopStanding::kLikely;
  } else if (loop.fit.squared >= config_.gate * config_.gate) {
    verdict.standing = LoopStanding::kContradicted;
  }
  return verdict;
}

void Examination::fillReport(RobustReport& report) const {
  report.weights.assign(graph_.constraints.size(), 1.0);
  for (const Doubtful& loop : loops_) {
    report.loops.push_back(verdictOn(loop));
    report.weights[loop.constraint] = report.loops.back().weight;
  }
  for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
    report.chi_square += report.weights[k] * chiSquare(graph_, graph_.constraints[k]);
  }
}

RobustReport Examination::run() {
  RobustReport report;
  const std::vector<geometry::Pose2> before = graph_.poses;
  FirstGuess guess = FirstGuess::kOdometry;
  bool is_settled = false;
  bool is_reopened = false;
  bool is_solved = true;
  while (is_solved && !is_settled && report.rounds < config_.max_rounds) {
    is_solved = solveRound(guess, kRoundLimits) != DescentEnd::kSingular && updateFits();
    guess = FirstGuess::kBest;
    ++report.rounds;
    const bool is_withdrawn = is_solved && withdrawWorst();
    const bool is_new = is_solved && believeConfirmed();
    const bool is_strict = share_ < 1.0;
    share_ = std::min(1.0, kShareGrowth * share_);
    is_settled = !is_strict && !is_withdrawn && !is_new && !presumeLikeliest();
    if (is_settled && !is_reopened) {
      is_reopened = true;
      is_settled = !reopen();
    }
  }
  const DescentEnd end = is_solved ? solveRound(FirstGuess::kGiven, config_.limits)
                                   : DescentEnd::kSingular;
  if (end == DescentEnd::kSingular || !updateFits()) {
    graph_.poses = before;
    report.status = SolveStatus::kFailed;
    report.message = "the information matrix is singular: some pose is not determined by the rest";
    return report;
  }
  if (!is_settled) {
    report.message = fmt::format("loops are still in doubt after {} rounds", report.rounds);
  }
  report.status = end == DescentEnd::kConverged && is_settled ? SolveStatus::kConverged
                                                              : SolveStatus::kIterationLimit;
  fillReport(report);
  return report;
}

}  // namespace

std::vector<std::string> RobustConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("gate", gate, 0.0);
  violations.requireAbove("accidents", accidents, 0.0);
  violations.requireWithin("supported_chance", supported_chance, 0.0, 1.0);
  violations.requireAtLeast("max_rounds", max_rounds, 1);
  violations.requireAtLeast("max_iterations", limits.max_iterations, 1);
  violations.requireWithin("relative_gain", limits.relative_gain, 0.0, 1.0);
  return violations.sentences();
}

std::string toString(LoopStanding standing) {
  switch (standing) {
    case LoopStanding::kConfirmed:
      return "confirmed";
    case LoopStanding::kLikely:
      return "likely";
    case LoopStanding::kOnlyTie:
      return "only tie";
    case LoopStanding::kContradicted:
      return "contradicted";
    case LoopStanding::kUnconfirmed:
      return "unconfirmed";
  }
  return "unknown";
}

RobustReport solveWithDoubtfulLoops(PoseGraph& graph, const RobustConfig& config) {
  geometry::throwIfAny(config.validate());
  if (graph.constraints.empty()) {
    return {};
  }
  if (!std::isfinite(chiSquare(graph))) {
    RobustReport report;
    report.status = SolveStatus::kFailed;
    report.message = "a pose or a constraint is not finite";
    return report;
  }
  return Examination(graph, config).run();
}

}  // namespace omega_slam::graph
