#include "experiments/match_account.h"

#include <algorithm>

#include "omega_slam/slam/front_end.h"

namespace omega_slam::experiments {

bool isTrusted(const matching::MatchResult& result) {
  return result.failure == matching::MatchFailure::kNone &&
         result.confidence >= slam::FrontEndConfig{}.min_confidence;
}

double eliminationQuotient(double before, double after) {
  return before > 0.0 ? 1.0 - after / before : 0.0;
}

double shareOf(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void MatchAccount::Sums::add(double error_before, double error_after, bool is_within) {
  ++count;
  within += is_within ? 1 : 0;
  before += error_before;
  after += error_after;
}

void MatchAccount::add(const MatchOutcome& outcome) {
  const bool within = outcome.error.isWithin(tolerance_);
  all_.add(outcome.squared_error_before, outcome.squared_error_after, within);
  if (outcome.determined) {
    determined_.add(outcome.squared_error_before, outcome.squared_error_after, within);
  }
  measured_before_ += outcome.measured_error_before;
  measured_after_ += outcome.measured_error_after;
  trusted_ += outcome.trusted ? 1 : 0;
  trusted_and_wrong_ += outcome.trusted && !within ? 1 : 0;
  quotients_.push_back(
      eliminationQuotient(outcome.squared_error_before, outcome.squared_error_after));
}

double MatchAccount::quotient() const { return eliminationQuotient(all_.before, all_.after); }

double MatchAccount::quotientOfDetermined() const {
  return eliminationQuotient(determined_.before, determined_.after);
}

double MatchAccount::medianQuotient() const {
  if (quotients_.empty()) {
    return 0.0;
  }
  std::vector<double> sorted = quotients_;
  const std::size_t middle = sorted.size() / 2;
  std::sort(sorted.begin(), sorted.end());
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double MatchAccount::measuredQuotient() const {
  return eliminationQuotient(measured_before_, measured_after_);
}

double MatchAccount::within() const { return shareOf(all_.within, all_.count); }

double MatchAccount::withinOfDetermined() const {
  return shareOf(determined_.within, determined_.count);
}

double MatchAccount::trusted() const { return shareOf(trusted_, all_.count); }

double MatchAccount::trustedAndWrong() const { return shareOf(trusted_and_wrong_, all_.count); }

}  // namespace omega_slam::experiments
