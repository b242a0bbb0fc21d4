#pragma once

#include <cstddef>
#include <vector>

#include "experiments/determination.h"

namespace omega_slam::experiments {

/// What became of one match, known after the fact.
struct MatchOutcome {
  double squared_error_before{0.0};   ///< [m^2] of the scans without noise, by the odometry
  double squared_error_after{0.0};    ///< [m^2] of the same, by the match
  double measured_error_before{0.0};  ///< [m^2] of the scans as they were measured
  double measured_error_after{0.0};   ///< [m^2]
  PoseError error{0.0, 0.0};          ///< of the match
  bool determined{true};              ///< whether the scans determine the pose
  bool trusted{false};                ///< whether the matcher is sure of itself
};

/// When a caller takes a match for good: the threshold of the front end.
[[nodiscard]] bool isTrusted(const matching::MatchResult& result);

/// The paper's error elimination quotient: 1 - error after / error before. 1: all gone; 0: nothing
/// gained; below 0: worse than the odometry. 0 where there was no error.
[[nodiscard]] double eliminationQuotient(double before, double after);

/// part / whole, 0 of nothing.
[[nodiscard]] double shareOf(std::size_t part, std::size_t whole);

/// What is said of many matches.
class MatchAccount {
 public:
  explicit MatchAccount(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void add(const MatchOutcome& outcome);

  [[nodiscard]] std::size_t count() const { return all_.count; }
  [[nodiscard]] std::size_t determined() const { return determined_.count; }
  /// Of the sums of all errors: a match that was easy does not outweigh one that was hard.
  [[nodiscard]] double quotient() const;
  [[nodiscard]] double quotientOfDetermined() const;
  [[nodiscard]] double medianQuotient() const;    ///< of all single matches
  [[nodiscard]] double measuredQuotient() const;  ///< noise of the sensor included
  [[nodiscard]] double within() const;            ///< share of all whose error is tolerable
  [[nodiscard]] double withinOfDetermined() const;
  [[nodiscard]] double trusted() const;          ///< share of all
  [[nodiscard]] double trustedAndWrong() const;  ///< share of all; wrong: beyond the tolerance

 private:
  struct Sums {
    std::size_t count{0};
    std::size_t within{0};
    double before{0.0};
    double after{0.0};

    void add(double error_before, double error_after, bool is_within);
  };

  Tolerance tolerance_;
  Sums all_;
  Sums determined_;
  double measured_before_{0.0};
  double measured_after_{0.0};
  std::size_t trusted_{0};
  std::size_t trusted_and_wrong_{0};
  std::vector<double> quotients_;
};

}  // namespace omega_slam::experiments
