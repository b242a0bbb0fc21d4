#include "omega_slam/slam/lost_judge.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::slam {

namespace {

constexpr double kPatience = 5.0;     // [s] of a robot that stands, or turns
constexpr double kLongestStep = 1.0;  // [s] of a scan, however long nothing was seen before it

/// A lost robot that sees something so sure is not lost any more: what blocked its view has gone.
constexpr double kSure = 0.8;

}  // namespace

void LostJudge::note(const TrackedScan& scan, const geometry::Pose2& motion, double seconds) {
  if (scan.is_contradicted) {
    way_ += std::hypot(motion.x, motion.y);
    time_ += std::min(seconds, kLongestStep);
    is_lost_ = is_lost_ || way_ >= lost_distance_ || time_ >= kPatience;
  } else if (scan.is_trusted && (!is_lost_ || scan.match.confidence >= kSure)) {
    rest();
  }
}

void LostJudge::rest() {
  way_ = 0.0;
  time_ = 0.0;
  is_lost_ = false;
}

}  // namespace omega_slam::slam
