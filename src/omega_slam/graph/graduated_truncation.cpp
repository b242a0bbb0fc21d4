#include "omega_slam/graph/graduated_truncation.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::graph {
namespace {

constexpr double kStageFactor = 1.4;  // Yang et al. 2020, remark 5
constexpr double kUndecided = 1e-3;

}  // namespace

GraduatedTruncation::GraduatedTruncation(double width, const std::vector<double>& squared)
    : limit_(width * width) {
  const double worst = squared.empty() ? 0.0 : *std::max_element(squared.begin(), squared.end());
  if (worst > limit_) {
    control_ = limit_ / (2.0 * worst - limit_);
  }
}

std::vector<double> GraduatedTruncation::weights(const std::vector<double>& squared) const {
  const double no_weight = (control_ + 1.0) / control_ * limit_;
  const double full_weight = control_ / (control_ + 1.0) * limit_;
  std::vector<double> weights;
  weights.reserve(squared.size());
  for (const double value : squared) {
    if (value >= no_weight) {
      weights.push_back(0.0);
    } else if (value <= full_weight) {
      weights.push_back(1.0);
    } else {
      weights.push_back(std::sqrt(limit_ * control_ * (control_ + 1.0) / value) - control_);
    }
  }
  return weights;
}

void GraduatedTruncation::advance() { control_ *= kStageFactor; }

bool areDecided(const std::vector<double>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](double weight) {
    return weight < kUndecided || weight > 1.0 - kUndecided;
  });
}

}  // namespace omega_slam::graph
