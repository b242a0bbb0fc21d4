#include "omega_slam/graph/robust_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "omega_slam/geometry/validation.h"
#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/doubtful_loops.h"
#include "omega_slam/graph/estimated_part.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/loop_examination.h"
#include "omega_slam/graph/loop_fit.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::graph {
namespace {

constexpr double kReluctance = 10.0;     // a loop that is believed may look so much more accidental
constexpr int kPatience = 2;             // a loop that was withdrawn so often has no further chance
constexpr double kLikelySquared = 11.3;  // 99 % of chi-square with 3 degrees of freedom
constexpr double kMedianSquared = 2.37;  // 50 %
constexpr std::size_t kSample = 20;      // loops from which the scale of covariances can be told
constexpr double kHeavyTail = 4.0;       // by which a variance so found is widened
constexpr double kFairOdds = 1.0;
constexpr double kFirstChance = 1e-7;  // up to which loops are believed in the first round
constexpr double kChanceGrowth = 10.0;
// Each round is solved until it rests: small unrest looks large in a loop that little else ties.
const DescentLimits kRoundLimits{20, 1e-8};

KernelConfig switches() {
  KernelConfig kernels;
  kernels.loop = {KernelKind::kGraduated, 1.0};  // weights as they are set
  return kernels;
}

class Examination {
 public:
  Examination(PoseGraph& graph, std::vector<DoubtfulLoop> loops, const RobustConfig& config);

  [[nodiscard]] RobustReport run();

 private:
  [[nodiscard]] DescentEnd solveRound(FirstGuess guess, const DescentLimits& limits);
  [[nodiscard]] bool updateFits();
  [[nodiscard]] double limitAlone() const;
  [[nodiscard]] double limitOf(const DoubtfulLoop& loop) const;
  bool withdrawWorst();
  bool believeConfirmed();
  bool believeSurest();
  bool presumeLikeliest();
  bool reopen();
  [[nodiscard]] std::optional<bool> advance(FirstGuess guess);
  [[nodiscard]] double varianceFactor() const;
  [[nodiscard]] LoopVerdict verdictOn(const DoubtfulLoop& loop) const;
  void fillReport(RobustReport& report) const;

  PoseGraph& graph_;
  const RobustConfig& config_;
  std::vector<DoubtfulLoop> loops_;
  Weighing weighing_;
  GraphSystem system_;
  ErrorSpace space_;
  double chance_{kFirstChance};  ///< up to which loops are believed at present
  bool is_reopened_{false};
  int iterations_{0};
};

Examination::Examination(PoseGraph& graph, std::vector<DoubtfulLoop> loops,
                         const RobustConfig& config)
    : graph_(graph), config_(config), loops_(std::move(loops)), weighing_(switches(), graph) {
  system_.prepare(graph_, spanningForest(graph_).roots);
}

DescentEnd Examination::solveRound(FirstGuess guess, const DescentLimits& limits) {
  PoseGraph believed = believedGraph(graph_, loops_);
  applyGuess(believed, guess);
  graph_.poses = std::move(believed.poses);
  std::vector<double> weights;
  weights.reserve(loops_.size());
  for (const DoubtfulLoop& loop : loops_) {
    weights.push_back(loop.is_believed ? 1.0 : 0.0);
  }
  weighing_.setStage(weights);
  const DescentAccount account = descendGaussNewton({graph_, system_, weighing_}, limits);
  iterations_ += static_cast<int>(account.chi_squares.size());
  return account.end;
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

/// Chance up to which the fit of a loop that stands alone is no accident.
double Examination::limitAlone() const {
  const auto count = static_cast<double>(std::max<std::size_t>(loops_.size(), 1));
  return std::min(config_.accidents / count, config_.supported_chance);
}

double Examination::limitOf(const DoubtfulLoop& loop) const {
  return loop.supporters.empty() ? limitAlone() : config_.supported_chance;
}

bool Examination::withdrawWorst() {
  DoubtfulLoop* worst = nullptr;
  double most = 1.0;
  for (DoubtfulLoop& loop : loops_) {
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
  for (DoubtfulLoop& loop : loops_) {
    if (!loop.is_believed && loop.withdrawals < kPatience &&
        loop.fit.squared < config_.gate * config_.gate &&
        chanceOf(loop.fit, space_) < std::min(chance_, limitOf(loop))) {
      loop.is_believed = is_any = true;
    }
  }
  return is_any;
}

/// What is surest: allows for more chance until something is believed.
bool Examination::believeSurest() {
  while (!believeConfirmed()) {
    if (chance_ >= config_.supported_chance) {
      return false;
    }
    chance_ = std::min(kChanceGrowth * chance_, config_.supported_chance);
  }
  return true;
}

/// A last chance for what was withdrawn while much was wrong.
bool Examination::reopen() {
  for (DoubtfulLoop& loop : loops_) {
    loop.withdrawals = std::min(loop.withdrawals, kPatience - 1);
  }
  return believeConfirmed();
}

/// By how much covariances are too large, seen from the loops that are believed: 1 if they are not.
double Examination::varianceFactor() const {
  std::vector<double> squared;
  for (const DoubtfulLoop& loop : loops_) {
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
  const auto mayBe = [&](const DoubtfulLoop& loop) {
    return !loop.is_believed && loop.withdrawals < kPatience &&
           loop.fit.squared < kLikelySquared * variance;
  };
  DoubtfulLoop* likeliest = nullptr;
  std::pair<bool, double> best{false, 0.0};
  for (DoubtfulLoop& loop : loops_) {
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

LoopVerdict Examination::verdictOn(const DoubtfulLoop& loop) const {
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
    const bool is_sure = !loop.is_presumed || verdict.chance < limitOf(loop);
    verdict.standing = is_sure ? LoopStanding::kConfirmed : LoopStanding::kLikely;
  } else if (loop.fit.squared >= config_.gate * config_.gate) {
    verdict.standing = LoopStanding::kContradicted;
  }
  return verdict;
}

void Examination::fillReport(RobustReport& report) const {
  SolveReport& solution = report.solution;
  solution.factorizations = system_.factorizations();
  solution.weights.assign(graph_.constraints.size(), 1.0);
  for (const DoubtfulLoop& loop : loops_) {
    report.loops.push_back(verdictOn(loop));
    solution.weights[loop.constraint] = report.loops.back().weight;
  }
  solution.chi_square = 0.0;
  for (std::size_t k = 0; k < graph_.constraints.size(); ++k) {
    solution.chi_square += solution.weights[k] * chiSquare(graph_, graph_.constraints[k]);
  }
}

/// One round. @return whether anything was changed; none where Omega is singular
std::optional<bool> Examination::advance(FirstGuess guess) {
  if (solveRound(guess, kRoundLimits) == DescentEnd::kSingular || !updateFits()) {
    return std::nullopt;
  }
  const bool is_withdrawn = withdrawWorst();
  const bool is_new = is_withdrawn ? believeConfirmed() : believeSurest();
  if (is_withdrawn || is_new) {
    chance_ = std::max(chance_, std::min(kChanceGrowth * chance_, limitAlone()));
    return true;
  }
  if (presumeLikeliest()) {
    return true;
  }
  const bool is_first_halt = !std::exchange(is_reopened_, true);
  return is_first_halt && reopen();
}

RobustReport Examination::run() {
  RobustReport report;
  SolveReport& solution = report.solution;
  solution.initial_chi_square = solution.chi_square = chiSquare(graph_);
  const std::vector<geometry::Pose2> before = graph_.poses;
  std::optional<bool> goes_on = true;
  for (; goes_on.value_or(false) && report.rounds < config_.max_rounds; ++report.rounds) {
    goes_on = advance(report.rounds == 0 ? FirstGuess::kOdometry : FirstGuess::kBest);
  }
  const DescentEnd end =
      goes_on ? solveRound(FirstGuess::kGiven, config_.limits) : DescentEnd::kSingular;
  if (end == DescentEnd::kSingular || !updateFits()) {
    graph_.poses = before;
    solution.status = SolveStatus::kFailed;
    solution.message =
        "the information matrix is singular: some pose is not determined by the rest";
    return report;
  }
  if (*goes_on) {
    solution.message = fmt::format("loops are still in doubt after {} rounds", report.rounds);
  }
  const bool is_at_rest = end == DescentEnd::kConverged && !*goes_on;
  solution.status = is_at_rest ? SolveStatus::kConverged : SolveStatus::kIterationLimit;
  solution.iterations = iterations_;
  fillReport(report);
  return report;
}

}  // namespace

std::vector<std::string> RobustConfig::validate() const {
  geometry::Violations violations;
  violations.requireAbove("gate", gate, 0.0);
  violations.requireAbove("accidents", accidents, 0.0);
  violations.requireWithin("supported_chance", supported_chance, 0.0, 1.0);
  violations.requireAbove("support.gate", support.gate, 0.0);
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
    report.solution.status = SolveStatus::kFailed;
    report.solution.message = "a pose or a constraint is not finite";
    return report;
  }
  // Which loops are near each other, the numbers of the whole graph say.
  const EstimatedPart part(graph);
  PoseGraph estimated = part.of(graph);
  RobustReport report = Examination(estimated, doubtfulLoops(graph, config.support), config).run();
  part.place(estimated.poses, graph);
  return report;
}

}  // namespace omega_slam::graph
