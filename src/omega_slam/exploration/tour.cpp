#include "omega_slam/exploration/tour.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace omega_slam::exploration {
namespace {

constexpr std::size_t kMaxStops = 12;
constexpr double kTurnCost = 0.6;       // [m/rad] about what the robot drives while it turns so far
constexpr double kUnreachable = 1.0e6;  // [m] longer than any way, but a number to reckon with

/// Indices of the options that are nearest to the robot.
std::vector<std::size_t> nearest(const std::vector<Option>& options) {
  std::vector<std::size_t> indices(options.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::sort(indices.begin(), indices.end(), [&options](std::size_t a, std::size_t b) {
    const auto rank = [&options](std::size_t i) {
      return std::make_pair(options[i].viewpoint.travel, options[i].frontier);
    };
    return rank(a) < rank(b);
  });
  indices.resize(std::min(indices.size(), kMaxStops));
  return indices;
}

TourCosts costsOf(const Situation& situation, const std::vector<std::size_t>& chosen) {
  TourCosts costs;
  const std::vector<double> home = situation.travelHome();
  for (const std::size_t from : chosen) {
    const Option& option = situation.options[from];
    costs.start.push_back(option.viewpoint.travel + kTurnCost * option.turn);
    costs.end.push_back(std::min(home[from], kUnreachable));
    const std::vector<double> row = situation.travelFrom(from);
    costs.between.emplace_back();
    for (const std::size_t to : chosen) {
      costs.between.back().push_back(std::min(row[to], kUnreachable));
    }
  }
  return costs;
}

}  // namespace

std::vector<double> costsByFirst(const TourCosts& costs) {
  const std::size_t count = costs.start.size();
  const std::size_t all = (std::size_t{1} << count) - 1;
  // rest[set][from]: from a stop through all those of the set to the end. A way counts once, and
  // once more for each stop that is reached by it, or after it.
  std::vector<std::vector<double>> rest(all + 1, std::vector<double>(count, 0.0));
  rest[0] = costs.end;
  std::vector<double> weights(all + 1, 1.0);
  for (std::size_t set = 1; set <= all; ++set) {
    weights[set] = weights[set >> 1U] + static_cast<double>(set & 1U);
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
  const std::vector<std::size_t> chosen = nearest(situation.options);
  const std::vector<double> costs = costsByFirst(costsOf(situation, chosen));
  const auto least = std::min_element(costs.begin(), costs.end());
  return chosen[static_cast<std::size_t>(least - costs.begin())];
}

}  // namespace omega_slam::exploration
