#pragma once

#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/graph/doubtful_loops.h"
#include "omega_slam/graph/loop_fit.h"
#include "omega_slam/graph/robust_loops.h"

namespace omega_slam::graph {

/// Which loops are believed, by how they fit: the rules of solveWithDoubtfulLoops(), from one round
/// to the next.
class LoopJudgement {
 public:
  LoopJudgement(std::vector<DoubtfulLoop> loops, const RobustConfig& config);

  [[nodiscard]] const std::vector<DoubtfulLoop>& loops() const { return loops_; }

  /// @param fits of the loops, in their order
  /// @param poses that these are fits to
  void hear(const std::vector<LoopFit>& fits, const std::vector<geometry::Pose2>& poses);

  /// Withdraws a loop, or believes others, as the last fits tell. @return whether any
  bool advance();

  /// Its chi-square excepted.
  [[nodiscard]] LoopVerdict verdictOn(const DoubtfulLoop& loop) const;

 private:
  [[nodiscard]] double limitAlone() const;
  [[nodiscard]] double limitOf(const DoubtfulLoop& loop) const;
  bool withdrawWorst();
  bool believeConfirmed();
  bool believeSurest();
  bool presumeLikeliest();
  bool reopen();
  [[nodiscard]] double varianceFactor() const;

  RobustConfig config_;
  std::vector<DoubtfulLoop> loops_;
  ErrorSpace space_;
  double chance_;  ///< up to which loops are believed at present
  bool is_reopened_{false};
};

}  // namespace omega_slam::graph
