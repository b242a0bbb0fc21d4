#include "omega_slam/exploration/strategy.h"

#include <utility>

namespace omega_slam::exploration {

std::size_t cheapest(const std::vector<Option>& options,
                     const std::function<double(const Option&)>& cost) {
  std::size_t best = 0;
  std::pair<double, FrontierId> best_rank{cost(options.front()), options.front().frontier};
  for (std::size_t i = 1; i < options.size(); ++i) {
    const std::pair<double, FrontierId> rank{cost(options[i]), options[i].frontier};
    if (rank < best_rank) {
      best = i;
      best_rank = rank;
    }
  }
  return best;
}

}  // namespace omega_slam::exploration
