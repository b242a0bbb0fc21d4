#include "omega_slam/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace omega_slam::evaluation {
namespace {

/// Mean and standard deviation of values to a power. Two passes: no cancellation.
std::pair<double, double> moments(const std::vector<double>& values, int power) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) {
    sum += std::pow(value, power);
  }
  const double mean = sum / count;
  double squares = 0.0;
  for (const double value : values) {
    const double difference = std::pow(value, power) - mean;
    squares += difference * difference;
  }
  return {mean, std::sqrt(squares / count)};
}

}  // namespace

double ErrorStatistics::rms() const { return std::sqrt(mean_square); }

ErrorStatistics summarize(const std::vector<double>& errors) {
  ErrorStatistics statistics;
  if (errors.empty()) {
    return statistics;
  }
  statistics.count = errors.size();
  std::tie(statistics.mean, statistics.deviation) = moments(errors, 1);
  std::tie(statistics.mean_square, statistics.square_deviation) = moments(errors, 2);
  statistics.max = *std::max_element(errors.begin(), errors.end());
  return statistics;
}

}  // namespace omega_slam::evaluation
