#pragma once

#include <string>
#include <vector>

#include "omega_slam/graph/loop_consistency.h"
#include "omega_slam/graph/pose_graph.h"
#include "omega_slam/graph/solver.h"

namespace omega_slam::graph {

struct RobustConfig {
  /// [standard deviations] A loop that lies farther off from what the rest says is not believed.
  /// Wide, since stated covariances are often too small; false loops rarely come so near.
  double gate{6.0};
  /// How many loops would be believed by accident in one examination if all were false.
  double accidents{0.1};
  /// Chance to fit as well by accident up to which a loop is believed that agrees with others; no
  /// loop is believed beyond it.
  double supported_chance{1e-3};
  SupportConfig support;  ///< which loops agree
  /// Of examinations, each with a solve.
  int max_rounds{100};
  DescentLimits limits{100, 1e-6};  ///< of the last solve

  [[nodiscard]] std::vector<std::string> validate() const;
};

/// Why a loop is believed, or not.
enum class LoopStanding {
  kConfirmed,     ///< believed: it fits so well as chance does not explain
  kLikely,        ///< believed: it fits, nothing speaks against it, and the odds are for it
  kOnlyTie,       ///< believed: without it a part of the graph would lie nowhere
  kContradicted,  ///< not believed: the rest says otherwise
  kUnconfirmed    ///< not believed: it would fit, but so would too many false ones
};

[[nodiscard]] std::string toString(LoopStanding standing);

/// What became of one loop.
struct LoopVerdict {
  std::size_t constraint{0};  ///< index
  LoopStanding standing{LoopStanding::kUnconfirmed};
  double weight{0.0};         ///< 1 if it is believed, 0 if not
  double chi_square{0.0};     ///< e^T Omega e at the solution
  double squared{0.0};        ///< LoopFit::squared with respect to all others that are believed
  double chance{0.0};         ///< chanceOf() that fit
  std::size_t supporters{0};  ///< loops nearby that agree with it
  [[nodiscard]] bool isBelieved() const { return weight > 0.0; }
};

struct RobustReport {
  /// Weights are 1 or 0; chi-squares after the solve are of what is believed alone.
  SolveReport solution;
  std::vector<LoopVerdict> loops;  ///< all of the graph, in its order
  int rounds{0};
};

/// Solves a graph of which any loop may be false, and tells the false ones from the true ones.
/// All other constraints are believed. The poses given matter only for the nodes that do not move.
///
/// Begins with no loop at all and believes those first that are hardest to fit by accident. Each
/// makes the graph stiffer, which makes the test harder for the next. Round by round:
///  1. the graph is solved with the loops that are believed, from the best of the first guesses and
///     the last solution;
///  2. every loop is examined (loop_fit.h): those believed against the graph without them, the
///     others against the graph, all with one SelectedInverse;
///  3. the believed loop that fits worst is withdrawn if it fails the gate: one at a time, since a
///     false loop makes its neighbours look bad (data snooping: Baarda 1968; Kok 1984);
///  4. loops are believed that pass the gate and whose fit is no accident: of false loops, fewer
///     than RobustConfig::accidents in all would fit as well. That is an a-contrario test
///     (Desolneux, Moisan and Morel, "Meaningful alignments", IJCV 40, 2000, definition 2), which
///     needs no covariances of the right scale, only of the right shape. Loops with agreeing
///     neighbours (Latif, Cadena and Neira, "Robust loop closing over time", IJRR 32, 2013, group
///     loops by the same thought) pass more easily. At first only the surest pass, then tenfold
///     chance each round;
///  5. where that comes to a halt, the one loop is presumed to be right for which the odds are
///     best, with those that agree with it, and the rounds go on.
/// Unlike RRR no cluster is solved for alone, unlike pairwise consistency maximisation (Mangelson
/// et al. 2018) no clique is looked for, and unlike graduated non-convexity no false loop ever
/// pulls while its weight shrinks.
///
/// Where most loops are known to be right, the search begins with these, from the poses given, and
/// what is left to find takes few rounds. They are presumed: withdrawn only if they fail the gate.
///
/// Deterministic. A round costs a solve, a factorisation and a SelectedInverse; ten rounds are
/// usual, and three where most is settled.
/// @param settled of each constraint, whether it is a loop to begin with; those that agree with
/// another that is not are not, either. Empty where nothing is known
/// @throws std::invalid_argument for a wrong configuration
RobustReport solveWithDoubtfulLoops(PoseGraph& graph, const RobustConfig& config = {},
                                    const std::vector<bool>& settled = {});

}  // namespace omega_slam::graph
