#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// All frontiers in the best order, with the way home at the end, of which the first is taken: the
/// nearest frontier leaves small ones behind, for which the robot must come back. Best is what
/// makes the way short, and a little what reaches frontiers early: by the way alone, where all ways
/// branch as in a maze, it does not matter which branch comes first, and a far one would be as good
/// as the nearest. By early arrival much, the robot would leave what is near for where there are
/// more of them.
///
/// Frontiers beside each other, which are seen together, are one stop. With many stops only the
/// nearest few are ordered: how far away ones are visited matters little now. The order is made
/// anew with each new map, since what has come into sight may lie on the way.
class Tour : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
  [[nodiscard]] bool choosesUnderWay() const override { return true; }
};

/// What ways between stops cost.
struct TourCosts {
  std::vector<double> start;                 ///< from where the tour begins to each stop
  std::vector<std::vector<double>> between;  ///< [from][to]
  std::vector<double> end;                   ///< from each stop to where the tour ends
};

/// For each stop, what the best tour costs that goes to it first, then through all others and to
/// the end: its length, and `eagerness` times for each stop the way until it is reached (travelling
/// salesman and repairman in one), by dynamic programming over sets of stops (Held and Karp, "A
/// Dynamic Programming Approach to Sequencing Problems", 1962). Time grows with n^2 2^n, memory
/// with n 2^n.
/// @return as many costs as there are stops
[[nodiscard]] std::vector<double> costsByFirst(const TourCosts& costs, double eagerness);

}  // namespace omega_slam::exploration
