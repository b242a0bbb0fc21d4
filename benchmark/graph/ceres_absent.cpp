#include "graph/contestants.h"

namespace omega_slam::experiments {

std::optional<GraphContestant> ceresContestant() { return std::nullopt; }

}  // namespace omega_slam::experiments
