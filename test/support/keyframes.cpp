#include "support/keyframes.h"

#include <random>

#include "omega_slam/sensing/scan_intake.h"
#include "support/room.h"

namespace omega_slam::test {

slam::KeyframePtr keyframeAt(graph::NodeId id, const geometry::Pose2& T_room_base,
                             graph::NodeId stretch) {
  std::mt19937_64 random(id);
  const auto scan = measure(furnishedRoom(), T_room_base, 360, 0.005, random);
  return std::make_shared<const slam::Keyframe>(
      slam::Keyframe{id, T_room_base, *sensing::ScanIntake({}).process(scan, {}).sweep, stretch});
}

}  // namespace omega_slam::test
