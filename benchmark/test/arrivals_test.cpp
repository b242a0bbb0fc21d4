#include "graph/arrivals.h"

#include <gtest/gtest.h>

namespace omega_slam::experiments {
namespace {

graph::Constraint tie(graph::NodeId from, graph::NodeId to) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  return constraint;
}

TEST(Arrivals, ANodeComesWithItsConstraintsToEarlierOnesTheLatestFirst) {
  graph::PoseGraph graph;
  graph.poses.resize(4);
  graph.constraints = {tie(3, 0), tie(0, 1), tie(1, 3), tie(3, 2)};
  const std::vector<Arrival> arrivals = arrivalsOf(graph);
  ASSERT_EQ(arrivals.size(), 4U);
  EXPECT_TRUE(arrivals[0].ties.empty() && arrivals[2].ties.empty());
  ASSERT_EQ(arrivals[1].ties.size(), 1U);
  EXPECT_TRUE(arrivals[1].loops.empty());
  ASSERT_EQ(arrivals[3].ties.size(), 1U);
  EXPECT_EQ(arrivals[3].ties[0].to, 2U);
  ASSERT_EQ(arrivals[3].loops.size(), 2U);
  EXPECT_EQ(arrivals[3].loops[0].from, 1U);
  EXPECT_EQ(arrivals[3].loops[1].to, 0U);
}

}  // namespace
}  // namespace omega_slam::experiments
