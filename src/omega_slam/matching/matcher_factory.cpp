#include "omega_slam/matching/matcher_factory.h"

#include <map>

#include "omega_slam/geometry/validation.h"

namespace omega_slam::matching {
namespace {

using MatcherPtr = std::unique_ptr<const ScanMatcher>;
using Maker = MatcherPtr (*)(const MatcherConfig&);

MatcherPtr makeCorrelative(const MatcherConfig& config) {
  return std::make_unique<CorrelativeMatcher>(config.correlative, config.match);
}

MatcherPtr makeHillClimbing(const MatcherConfig& config) {
  return std::make_unique<HillClimbingMatcher>(config.hill_climbing, config.match);
}

MatcherPtr makeIcp(const MatcherConfig& config) {
  return std::make_unique<IcpMatcher>(config.icp, config.match);
}

MatcherPtr makeParticles(const MatcherConfig& config) {
  return std::make_unique<ParticleMatcher>(config.particles, config.match);
}

MatcherPtr makePointToLine(const MatcherConfig& config) {
  return std::make_unique<PointToLineMatcher>(config.point_to_line, config.match);
}

MatcherPtr makeScanToMap(const MatcherConfig& config) {
  return std::make_unique<MapMatcher>(config.scan_to_map, config.match, makeCorrelative(config));
}

const std::map<std::string, Maker> kMakers{{"correlative", makeCorrelative},
                                           {"hill_climbing", makeHillClimbing},
                                           {"icp", makeIcp},
                                           {"particles", makeParticles},
                                           {"point_to_line", makePointToLine},
                                           {"scan_to_map", makeScanToMap}};

}  // namespace

std::vector<std::string> MatcherConfig::validate() const {
  geometry::Violations violations;
  violations.include("match", match.validate());
  violations.include("correlative", correlative.validate());
  violations.include("hill_climbing", hill_climbing.validate());
  violations.include("icp", icp.validate());
  violations.include("particles", particles.validate());
  violations.include("point_to_line", point_to_line.validate());
  violations.include("scan_to_map", scan_to_map.validate());
  std::vector<std::string> sentences = violations.sentences();
  if (kMakers.count(matcher) == 0) {
    sentences.push_back("matcher is \"" + matcher + "\", but there is none of that name.");
  }
  return sentences;
}

std::vector<std::string> matcherNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : kMakers) {
    names.push_back(name);
  }
  return names;
}

std::unique_ptr<const ScanMatcher> makeMatcher(const MatcherConfig& config) {
  geometry::throwIfAny(config.validate());
  return kMakers.at(config.matcher)(config);
}

}  // namespace omega_slam::matching
