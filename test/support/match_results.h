#pragma once

#include "omega_slam/matching/scan_matcher.h"

namespace omega_slam::test {

/// Expects a result that a caller can use whatever the input was: all of it finite, the confidence
/// in [0, 1].
void expectFinite(const matching::MatchResult& result);

}  // namespace omega_slam::test
