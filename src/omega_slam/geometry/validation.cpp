#include "omega_slam/geometry/validation.h"

#include <fmt/format.h>

#include <stdexcept>

namespace omega_slam::geometry {

// Each test is written so that NaN fails it.

void Violations::requireAtLeast(const std::string& name, double value, double min) {
  if (!(value >= min)) {
    sentences_.push_back(fmt::format("{} is {}, but must be at least {}.", name, value, min));
  }
}

void Violations::requireAbove(const std::string& name, double value, double bound) {
  if (!(value > bound)) {
    sentences_.push_back(fmt::format("{} is {}, but must be above {}.", name, value, bound));
  }
}

void Violations::requireWithin(const std::string& name, double value, double min, double max) {
  if (!(value >= min && value <= max)) {
    sentences_.push_back(
        fmt::format("{} is {}, but must lie within {} and {}.", name, value, min, max));
  }
}

void Violations::include(const std::string& part, const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    sentences_.push_back(part + "/" + sentence);
  }
}

void throwIfAny(const std::vector<std::string>& sentences) {
  if (sentences.empty()) {
    return;
  }
  std::string all;
  for (const std::string& sentence : sentences) {
    all += (all.empty() ? "" : " ") + sentence;
  }
  throw std::invalid_argument(all);
}

}  // namespace omega_slam::geometry
