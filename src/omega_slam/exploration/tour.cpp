#include "omega_slam/exploration/tour.h"

#include <algorithm>
#include <numeric>

namespace omega_slam::exploration {
namespace {

constexpr std::size_t kMaxStops = 12;
constexpr double kTurnCost = 0.6;       // [m/rad] about what the robot drives while it turns so far
constexpr double kUnreachable = 1.0e6;  // [m] longer than any way, but a number to reckon with
constexpr double kLeastGain = 1.0e-9;   // [m] less is rounding

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

/// Stop 0 is the robot, stop i + 1 the option `chosen[i]`.
TravelMatrix matrixOf(const Situation& situation, const std::vector<std::size_t>& chosen) {
  TravelMatrix travel(chosen.size() + 1, std::vector<double>(chosen.size() + 1, 0.0));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Option& option = situation.options[chosen[i]];
    travel[0][i + 1] = option.viewpoint.travel + kTurnCost * option.turn;
    travel[i + 1][0] = travel[0][i + 1];
    const std::vector<double> row = situation.travelFrom(chosen[i]);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      travel[i + 1][k + 1] = std::min(row[chosen[k]], kUnreachable);
    }
  }
  return travel;
}

/// What it costs more to stop at `stop` before the place `at` of the tour; at its end it only adds.
double detour(const std::vector<std::size_t>& tour, std::size_t at, std::size_t stop,
              const TravelMatrix& travel) {
  const std::size_t before = tour[at - 1];
  if (at == tour.size()) {
    return travel[before][stop];
  }
  return travel[before][stop] + travel[stop][tour[at]] - travel[before][tour[at]];
}

std::vector<std::size_t> insertAll(const TravelMatrix& travel) {
  std::vector<std::size_t> tour{0};
  std::vector<std::size_t> rest(travel.size() - 1);
  std::iota(rest.begin(), rest.end(), std::size_t{1});
  while (!rest.empty()) {
    std::size_t best_stop = 0;
    std::size_t best_place = 1;
    double best = 2.0 * kUnreachable + detour(tour, 1, rest[0], travel);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      for (std::size_t at = tour.size(); at > 0; --at) {
        if (const double cost = detour(tour, at, rest[i], travel); cost < best) {
          best = cost;
          best_stop = i;
          best_place = at;
        }
      }
    }
    tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(best_place), rest[best_stop]);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best_stop));
  }
  return tour;
}

/// What is saved by turning the stops from `first` to `last` around.
double savedByTurning(const std::vector<std::size_t>& tour, std::size_t first, std::size_t last,
                      const TravelMatrix& travel) {
  double saved = travel[tour[first - 1]][tour[first]] - travel[tour[first - 1]][tour[last]];
  if (last + 1 < tour.size()) {
    saved += travel[tour[last]][tour[last + 1]] - travel[tour[first]][tour[last + 1]];
  }
  return saved;
}

bool improve(std::vector<std::size_t>& tour, const TravelMatrix& travel) {
  for (std::size_t first = 1; first < tour.size(); ++first) {
    for (std::size_t last = first + 1; last < tour.size(); ++last) {
      if (savedByTurning(tour, first, last, travel) > kLeastGain) {
        std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(first),
                     tour.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<std::size_t> shortTour(const TravelMatrix& travel) {
  if (travel.empty()) {
    return {};
  }
  std::vector<std::size_t> tour = insertAll(travel);
  while (improve(tour, travel)) {  // each time it gets shorter, so it ends
  }
  return tour;
}

double lengthOf(const std::vector<std::size_t>& tour, const TravelMatrix& travel) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    length += travel[tour[i]][tour[i + 1]];
  }
  return length;
}

std::size_t Tour::choose(const Situation& situation) const {
  const std::vector<std::size_t> chosen = nearest(situation.options);
  return chosen[shortTour(matrixOf(situation, chosen))[1] - 1];
}

}  // namespace omega_slam::exploration
