#include "omega_slam/simulation/validation.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace omega_slam::simulation {

void Violations::requirePositive(const std::string& key, double value) {
  require(std::isfinite(value) && value > 0.0, fmt::format("{} must be above 0.", key));
}

void Violations::requireNotNegative(const std::string& key, double value) {
  require(std::isfinite(value) && value >= 0.0, fmt::format("{} must not be below 0.", key));
}

void Violations::require(bool condition, const std::string& sentence) {
  if (!condition) {
    sentences_.push_back(sentence);
  }
}

void throwIfAny(const std::vector<std::string>& violations) {
  if (!violations.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(violations, " ")));
  }
}

}  // namespace omega_slam::simulation
