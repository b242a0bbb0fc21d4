#pragma once

#include "omega_slam/slam/keyframe.h"

namespace omega_slam::test {

/// Of a full turn in the furnished room, with the true pose for odometry; the id is the seed.
[[nodiscard]] slam::KeyframePtr keyframeAt(graph::NodeId id, const geometry::Pose2& T_room_base,
                                           graph::NodeId stretch = 0);

}  // namespace omega_slam::test
