#include "omega_slam/exploration/tour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace omega_slam::exploration {
namespace {

constexpr std::size_t kMaxStops = 12;
constexpr double kTogether = 1.5;       // [m] options nearer to each other are one stop
constexpr double kTurnCost = 0.6;       // [m/rad] about what the robot drives while it turns so far
constexpr double kConstancy = 1.0;      // [m] that the way to where the robot goes already is less
constexpr double kEagerness = 0.3;      // of a metre, for each stop that is reached by it or after
constexpr double kUnreachable = 1.0e6;  // [m] longer than any way, but a number to reckon with

/// Whether what is to be seen from one will likely be seen on the way to the other. Walls between
/// them show by the ways from the robot.
bool isTogether(const Viewpoint& a, const Viewpoint& b) {
  return geometry::distance(a.T_map_base, b.T_map_base) < kTogether &&
         std::abs(a.travel - b.travel) < kTogether;
}

/// Indices of the options that are stops, the nearest of those together; but first of all the one
/// that the robot is on its way to.
std::vector<std::size_t> stopsOf(const Situation& situation) {
  const std::vector<Option>& options = situation.options;
  const auto rank = [&](std::size_t i) {
    const bool is_other = options[i].frontier != situation.current;
    return std::make_tuple(is_other, options[i].viewpoint.travel, options[i].frontier);
  };
  std::vector<std::size_t> indices(options.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::sort(indices.begin(), indices.end(),
            [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<std::size_t> stops;
  for (const std::size_t i : indices) {
    const bool is_stop = std::none_of(stops.begin(), stops.end(), [&](std::size_t stop) {
      return isTogether(options[i].viewpoint, options[stop].viewpoint);
    });
    if (is_stop && stops.size() < kMaxStops) {
      stops.push_back(i);
    }
  }
  return stops;
}

TourCosts costsOf(const Situation& situation, const std::vector<std::size_t>& stops) {
  TourCosts costs;
  const std::vector<double> home = situation.travelHome();
  for (const std::size_t from : stops) {
    const Option& option = situation.options[from];
    const double constancy = option.frontier == situation.current ? kConstancy : 0.0;
    costs.start.push_back(option.viewpoint.travel + kTurnCost * option.turn - constancy);
    costs.end.push_back(std::min(home[from], kUnreachable));
    const std::vector<double> row = situation.travelFrom(from);
    costs.between.emplace_back();
    for (const std::size_t to : stops) {
      costs.between.back().push_back(std::min(row[to], kUnreachable));
    }
  }
  return costs;
}

}  // namespace

std::vector<double> costsByFirst(const TourCosts& costs, double eagerness) {
  const std::size_t count = costs.start.size();
  const std::size_t all = (std::size_t{1} << count) - 1;
  // rest[set][from]: from a stop through all those of the set to the end. A way counts once, and
  // by `eagerness` once more for each stop that is reached by it, or after it.
  std::vector<std::vector<double>> rest(all + 1, std::vector<double>(count, 0.0));
  rest[0] = costs.end;
  std::vector<double> weights(all + 1, 1.0);
  for (std::size_t set = 1; set <= all; ++set) {
    weights[set] = weights[set >> 1U] + eagerness * static_cast<double>(set & 1U);
    for (std::size_t from = 0; from < count; ++from) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t to = 0; to < count; ++to) {
        const std::size_t stop = std::size_t{1} << to;
        if ((set & stop) != 0) {
          least = std::min(least, weights[set] * costs.between[from][to] + rest[set & ~stop][to]);
        }
      }
      rest[set][from] = least;
    }
  }
  std::vector<double> result;
  for (std::size_t first = 0; first < count; ++first) {
    result.push_back(weights[all] * costs.start[first] +
                     rest[all & ~(std::size_t{1} << first)][first]);
  }
  return result;
}

std::size_t Tour::choose(const Situation& situation) const {
  const std::vector<std::size_t> stops = stopsOf(situation);
  const std::vector<double> costs = costsByFirst(costsOf(situation, stops), kEagerness);
  const auto least = std::min_element(costs.begin(), costs.end());
  return stops[static_cast<std::size_t>(least - costs.begin())];
}

}  // namespace omega_slam::exploration
