#pragma once

#include "omega_slam/graph/pose_graph.h"

namespace omega_slam::graph {

/// Headings from the measured turns alone, whatever the poses were before, then positions from the
/// measured steps. Both are linear problems, which have one minimum: the rotations are looked for
/// among all matrices that turn and scale, and scaled back (Carlone, Tron, Daniilidis and Dellaert,
/// "Initialization techniques for 3D SLAM", ICRA 2015, section III-B; in the plane, a rotation is a
/// unit vector). The roots of the graph's
/// spanningForest() stay. Leaves the graph as it is where a problem
/// has no solution.
void relaxChordally(PoseGraph& graph);

}  // namespace omega_slam::graph
