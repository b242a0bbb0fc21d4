#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "omega_slam/evaluation/report.h"

namespace omega_slam {

/// How long the steps of the chain take in real time, seen from outside: from the moment that one
/// message arrives to the moment that its successor does. Stamps tell which belongs to which.
class RunDelays {
 public:
  /// A message has come that something will follow from. Only the first with a stamp counts.
  /// @param step  name of what follows, such as "scan to keyframe"
  /// @param stamp [ns] by which the successor is known
  /// @param wall_time [s] of a clock that never stands still
  void begin(const std::string& step, std::uint64_t stamp, double wall_time);

  /// The successor has come. Steps begun with older stamps will not be finished any more.
  void end(const std::string& step, std::uint64_t stamp, double wall_time);

  [[nodiscard]] std::vector<evaluation::TimingFigures> summarize() const;

 private:
  struct Step {
    std::map<std::uint64_t, double> begun;  ///< wall time [s] by stamp
    std::vector<double> seconds;            ///< [s] of what is finished
  };
  std::map<std::string, Step> steps_;
};

}  // namespace omega_slam
