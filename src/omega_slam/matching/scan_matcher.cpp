#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::matching {

std::string toString(MatchFailure failure) {
  switch (failure) {
    case MatchFailure::kNone:
      return "none";
    case MatchFailure::kTooFewReturns:
      return "too few returns";
    case MatchFailure::kNoOverlap:
      return "no overlap";
    case MatchFailure::kDegenerate:
      return "degenerate";
    case MatchFailure::kNotConverged:
      return "not converged";
  }
  return "unknown";
}

}  // namespace omega_slam::matching
