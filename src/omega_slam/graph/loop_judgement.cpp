#include "omega_slam/graph/loop_judgement.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

LoopJudgement::LoopJudgement(std::vector<DoubtfulLoop> loops, const RobustConfig& config)
    : config_(config), loops_(std::move(loops)), chance_(kFirstChance) {}

void LoopJudgement::hear(const std::vector<LoopFit>& fits,
                         const std::vector<geometry::Pose2>& poses) {
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    loops_[i].fit = fits[i];
  }
  space_ = ErrorSpace::of(poses);
}

/// Chance up to which the fit of a loop that stands alone is no accident.
double LoopJudgement::limitAlone() const {
  const auto count = static_cast<double>(std::max<std::size_t>(loops_.size(), 1));
  return std::min(config_.accidents / count, config_.supported_chance);
}

double LoopJudgement::limitOf(const DoubtfulLoop& loop) const {
  return loop.supporters.empty() ? limitAlone() : config_.supported_chance;
}

bool LoopJudgement::withdrawWorst() {
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

bool LoopJudgement::believeConfirmed() {
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
bool LoopJudgement::believeSurest() {
  while (!believeConfirmed()) {
    if (chance_ >= config_.supported_chance) {
      return false;
    }
    chance_ = std::min(kChanceGrowth * chance_, config_.supported_chance);
  }
  return true;
}

/// A last chance for what was withdrawn while much was wrong.
bool LoopJudgement::reopen() {
  for (DoubtfulLoop& loop : loops_) {
    loop.withdrawals = std::min(loop.withdrawals, kPatience - 1);
  }
  return believeConfirmed();
}

/// By how much covariances are too large, seen from the loops that are believed: 1 if they are not.
double LoopJudgement::varianceFactor() const {
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

bool LoopJudgement::presumeLikeliest() {
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

bool LoopJudgement::advance() {
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

LoopVerdict LoopJudgement::verdictOn(const DoubtfulLoop& loop) const {
  LoopVerdict verdict;
  verdict.constraint = loop.constraint;
  verdict.weight = loop.is_believed ? 1.0 : 0.0;
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

}  // namespace omega_slam::graph
