#include "nodes/common/graph_markers.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace omega_slam {
namespace {

using visualization_msgs::Marker;

graph::Constraint edge(graph::NodeId from, graph::NodeId to, graph::ConstraintKind kind) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.kind = kind;
  return constraint;
}

TEST(GraphMarkers, EveryKindOfEdgeIsDrawnBetweenItsKeyframes) {
  graph::PoseGraph graph;
  graph.poses = {{0.0, 0.0, 0.0}, {1.0, 2.0, 0.0}, {3.0, 4.0, 0.0}};
  graph.constraints = {edge(0, 1, graph::ConstraintKind::kOdometry),
                       edge(0, 1, graph::ConstraintKind::kMatch),
                       edge(2, 0, graph::ConstraintKind::kLoop)};
  std_msgs::Header header;
  header.frame_id = "map";
  std::map<std::string, Marker> markers;
  for (const Marker& marker : graphMarkers(graph, header).markers) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.action, Marker::ADD);
    markers[marker.ns] = marker;
  }
  EXPECT_EQ(markers.at("keyframes").points.size(), 3U);
  EXPECT_EQ(markers.at("odometry").points.size(), 2U);
  EXPECT_EQ(markers.at("matches").points.size(), 2U);
  ASSERT_EQ(markers.at("loops").points.size(), 2U);
  EXPECT_EQ(markers.at("loops").points[0].x, 3.0);
  EXPECT_EQ(markers.at("loops").points[1].x, 0.0);
}

TEST(GraphMarkers, WhatIsEmptyIsTakenAway) {
  for (const Marker& marker : graphMarkers({}, {}).markers) {
    EXPECT_EQ(marker.action, Marker::DELETE) << marker.ns;
  }
}

}  // namespace
}  // namespace omega_slam
