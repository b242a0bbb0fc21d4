#include "nodes/common/sequence_gaps.h"

namespace omega_slam {

namespace {

constexpr std::uint32_t kMost = 1000;  // a larger gap is another count

}  // namespace

std::uint32_t SequenceGaps::lostBefore(const std::string& publisher, std::uint32_t sequence) {
  const auto [known, is_first] = last_.emplace(publisher, sequence);
  if (is_first) {
    return 0;
  }
  const std::uint32_t step = sequence - known->second;  // wraps around as the numbers do
  known->second = sequence;
  return step > 1 && step <= kMost ? step - 1 : 0;
}

}  // namespace omega_slam
