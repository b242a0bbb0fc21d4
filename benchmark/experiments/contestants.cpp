#include "experiments/contestants.h"

#include <algorithm>

#include "experiments/peers.h"

namespace omega_slam::experiments {

matching::MatcherConfig configFor(const std::string& matcher, const Tolerance& guess_error) {
  matching::MatcherConfig config;
  config.matcher = matcher;
  // ICP pairs points so far apart at first: less than the noise, and most have no partner.
  config.icp.max_correspondence_distance =
      std::max(config.icp.max_correspondence_distance, guess_error.translation);
  // Hill climbing looks so far to each side, and nine in ten particles begin so near.
  config.hill_climbing.distance_reach =
      std::max(config.hill_climbing.distance_reach, guess_error.translation);
  config.hill_climbing.rotation_reach =
      std::max(config.hill_climbing.rotation_reach, guess_error.rotation);
  config.particles.translation_deviation =
      std::max(config.particles.translation_deviation, 0.5 * guess_error.translation);
  config.particles.rotation_deviation =
      std::max(config.particles.rotation_deviation, 0.5 * guess_error.rotation);
  // The correlative matcher looks no farther than its window.
  matching::SearchWindow& window = config.correlative.window;
  window.translation = std::max(window.translation, guess_error.translation);
  window.rotation = std::max(window.rotation, guess_error.rotation);
  return config;
}

std::vector<Contestant> ownMatchers(const Tolerance& guess_error,
                                    const std::vector<std::string>& names) {
  std::vector<Contestant> contestants;
  for (const std::string& name : names.empty() ? matching::matcherNames() : names) {
    contestants.push_back({name, matching::makeMatcher(configFor(name, guess_error))});
  }
  return contestants;
}

std::vector<Contestant> peers() {
  std::vector<Contestant> contestants;
  contestants.push_back({"pcl_icp", std::make_unique<PclIcp>()});
  contestants.push_back({"pcl_ndt", std::make_unique<PclNdt>()});
  return contestants;
}

}  // namespace omega_slam::experiments
