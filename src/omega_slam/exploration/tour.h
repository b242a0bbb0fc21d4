#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "omega_slam/exploration/strategy.h"

namespace omega_slam::exploration {

/// All frontiers in the order in which visiting them makes the shortest way, of which the first is
/// taken: the nearest frontier leaves small ones behind, for which the robot must come back.
///
/// With many frontiers only the nearest few are ordered: how far away ones are visited matters
/// little now.
class Tour : public Strategy {
 public:
  [[nodiscard]] std::size_t choose(const Situation& situation) const override;
};

/// Lengths of ways between stops: [from][to]. Stop 0 is where the tour begins.
using TravelMatrix = std::vector<std::vector<double>>;

/// An open tour through all stops that begins at stop 0 and ends anywhere: built by inserting the
/// stop that costs least where it costs least, then improved by turning sections around (2-opt,
/// Croes, "A Method for Solving Traveling-Salesman Problems", 1958) until none helps. Ways are as
/// long in both directions. Deterministic; time is cubic in the number of stops.
/// @return stops in order, 0 first; empty for an empty matrix
[[nodiscard]] std::vector<std::size_t> shortTour(const TravelMatrix& travel);

/// [m] of a tour.
[[nodiscard]] double lengthOf(const std::vector<std::size_t>& tour, const TravelMatrix& travel);

}  // namespace omega_slam::exploration
