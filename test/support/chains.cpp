#include "support/chains.h"

namespace omega_slam::test {

graph::PoseGraph chainOf(const std::vector<geometry::Pose2>& poses, double deviation) {
  graph::PoseGraph graph;
  graph.poses = poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    graph::Constraint tie;
    tie.from = static_cast<graph::NodeId>(i - 1);
    tie.to = static_cast<graph::NodeId>(i);
    tie.T_from_to = relativePose(poses[i - 1], poses[i]);
    tie.information = Eigen::Matrix3d::Identity() / (deviation * deviation);
    graph.constraints.push_back(tie);
  }
  return graph;
}

}  // namespace omega_slam::test
