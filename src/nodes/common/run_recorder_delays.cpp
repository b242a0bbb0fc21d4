#include "nodes/common/run_recorder_delays.h"

namespace omega_slam {

void RunDelays::begin(const std::string& step, std::uint64_t stamp, double wall_time) {
  steps_[step].begun.emplace(stamp, wall_time);
}

void RunDelays::end(const std::string& step, std::uint64_t stamp, double wall_time) {
  auto& [begun, seconds] = steps_[step];
  const auto found = begun.find(stamp);
  if (found != begun.end()) {
    seconds.push_back(wall_time - found->second);
  }
  begun.erase(begun.begin(), begun.upper_bound(stamp));
}

std::vector<evaluation::TimingFigures> RunDelays::summarize() const {
  std::vector<evaluation::TimingFigures> figures;
  for (const auto& [name, step] : steps_) {
    if (!step.seconds.empty()) {
      figures.push_back(evaluation::summarizeTimes(name, step.seconds));
    }
  }
  return figures;
}

}  // namespace omega_slam
