#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace omega_slam {

/// Finds out how many messages of a topic were lost on their way: a subscriber's queue that is full
/// drops the oldest one and tells nobody, but publishers number what they send. Not thread-safe.
class SequenceGaps {
 public:
  /// @param sequence the number in the message's header
  /// @return how many of this publisher's messages were lost between the last one and this one;
  /// none where numbers begin anew, stand still, or leave out more than anybody would send
  [[nodiscard]] std::uint32_t lostBefore(const std::string& publisher, std::uint32_t sequence);

 private:
  std::map<std::string, std::uint32_t> last_;  ///< number, by publisher
};

}  // namespace omega_slam
