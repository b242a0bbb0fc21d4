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
constexpr double kNook = 1.0;           // [m^2] what is smaller may be left out,
constexpr double kWorth = 4.0;          // [m/m^2] if the way to it is longer than it is worth
constexpr double kAtHome = 1.0;         // [m] around where it began, what is unknown is no nook
constexpr double kUnreachable = 1.0e6;  // [m] longer than any way, but a number to reckon with
constexpr double kMust = 1.0e9;         // [m] more than any tour: what leaving out all else costs

/// Whether what is to be seen from one will likely be seen on the way to the other. Walls between
/// them show by the ways from the robot.
bool isTogether(const Viewpoint& a, const Viewpoint& b) {
  return geometry::distance(a.T_map_base, b.T_map_base) < kTogether &&
         std::abs(a.travel - b.travel) < kTogether;
}

/// Frontiers that are seen together.
struct Stop {
  std::size_t option{0};  ///< the nearest of them
  double price{0.0};      ///< [m] of leaving all of them out
};

/// [m] of leaving an option out. Where the robot began it did not see its own place, and it must,
/// to come home.
double priceOf(const Option& option, const Situation& situation) {
  const Eigen::Vector2d place = option.viewpoint.T_map_base.translation();
  const bool is_home = (place - situation.origin).norm() < kAtHome;
  return is_home || option.behind >= kNook ? kMust : kWorth * option.behind;
}

/// The options as stops, the nearest first; but first of all the one that the robot is on its way
/// to.
std::vector<Stop> stopsOf(const Situation& situation) {
  const std::vector<Option>& options = situation.options;
  const auto rank = [&](std::size_t i) {
    const bool is_other = options[i].frontier != situation.current;
    return std::make_tuple(is_other, options[i].viewpoint.travel, options[i].frontier);
  };
  std::vector<std::size_t> indices(options.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::sort(indices.begin(), indices.end(),
            [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<Stop> stops;
  for (const std::size_t i : indices) {
    const auto together = std::find_if(stops.begin(), stops.end(), [&](const Stop& stop) {
      return isTogether(options[i].viewpoint, options[stop.option].viewpoint);
    });
    const double price = priceOf(options[i], situation);
    if (together == stops.end()) {
      stops.push_back({i, price});
    } else {
      together->price += price;
    }
  }
  return stops;
}

TourCosts costsOf(const Situation& situation, const std::vector<Stop>& stops) {
  TourCosts costs;
  const std::vector<double> home = situation.travelHome();
  for (const Stop& from : stops) {
    const Option& option = situation.options[from.option];
    const double constancy = option.frontier == situation.current ? kConstancy : 0.0;
    costs.start.push_back(option.viewpoint.travel + kTurnCost * option.turn - constancy);
    costs.end.push_back(std::min(home[from.option], kUnreachable));
    costs.skip.push_back(from.price);
    costs.eagerness.push_back(from.price < kMust ? 0.0 : kEagerness);
    const std::vector<double> row = situation.travelFrom(from.option);
    costs.between.emplace_back();
    for (const Stop& to : stops) {
      costs.between.back().push_back(std::min(row[to.option], kUnreachable));
    }
  }
  return costs;
}

}  // namespace

std::vector<double> costsByFirst(const TourCosts& costs) {
  const std::size_t count = costs.start.size();
  const std::size_t all = (std::size_t{1} << count) - 1;
  // rest[set][from]: from a stop through those of the set that are worth it to the end.
  std::vector<std::vector<double>> rest(all + 1, std::vector<double>(count, 0.0));
  rest[0] = costs.end;
  std::vector<double> weights(all + 1, 1.0);  // of a way by what is still to come
  std::vector<double> skips(all + 1, 0.0);
  for (std::size_t set = 1; set <= all; ++set) {
    for (std::size_t stop = 0; stop < count; ++stop) {
      const bool is_in = (set >> stop & 1U) != 0;
      weights[set] += is_in ? costs.eagerness[stop] : 0.0;
      skips[set] += is_in ? costs.skip[stop] : 0.0;
    }
    for (std::size_t from = 0; from < count; ++from) {
      double least = costs.end[from] + skips[set];
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

std::optional<std::size_t> Tour::choose(const Situation& situation) const {
  std::vector<Stop> stops = stopsOf(situation);
  while (!stops.empty()) {
    const auto few = stops.begin() + static_cast<std::ptrdiff_t>(std::min(stops.size(), kMaxStops));
    const std::vector<Stop> near(stops.begin(), few);
    const TourCosts now = costsOf(situation, near);
    const std::vector<double> costs = costsByFirst(now);
    const auto least = std::min_element(costs.begin(), costs.end());
    if (*least < std::accumulate(now.skip.begin(), now.skip.end(), situation.home)) {
      return near[static_cast<std::size_t>(least - costs.begin())].option;
    }
    stops.erase(stops.begin(), few);
  }
  return std::nullopt;
}

}  // namespace omega_slam::exploration
