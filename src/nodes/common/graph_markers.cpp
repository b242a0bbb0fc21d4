#include "nodes/common/graph_markers.h"

#include <array>

#include "nodes/common/markers.h"

namespace omega_slam {
namespace {

using visualization_msgs::Marker;

constexpr double kDot = 0.12;   // [m]
constexpr double kLine = 0.02;  // [m]
// Edges lie under the dots, and loops over the other edges, so that none hides what matters more
// [m].
constexpr double kEdgeHeight = 0.02;
constexpr double kLoopHeight = 0.04;
constexpr double kDotHeight = 0.06;

struct Style {
  graph::ConstraintKind kind;
  const char* name;
  std_msgs::ColorRGBA color;
  double height;  // [m]
};

std::array<Style, 3> edgeStyles() {
  return {
      {{graph::ConstraintKind::kOdometry, "odometry", color(0.6F, 0.6F, 0.6F, 0.8F), kEdgeHeight},
       {graph::ConstraintKind::kMatch, "matches", color(0.1F, 0.5F, 1.0F, 0.9F), kEdgeHeight},
       {graph::ConstraintKind::kLoop, "loops", color(1.0F, 0.2F, 0.1F, 1.0F), kLoopHeight}}};
}

Marker nodeMarker(const graph::PoseGraph& graph, const std_msgs::Header& header) {
  Marker marker = makeMarker(header, "keyframes", Marker::SPHERE_LIST);
  marker.scale.x = kDot;
  marker.scale.y = kDot;
  marker.scale.z = kDot;
  marker.color = color(0.1F, 0.7F, 0.2F, 1.0F);
  for (const geometry::Pose2& pose : graph.poses) {
    marker.points.push_back(pointAt(pose.translation(), kDotHeight));
  }
  return marker;
}

Marker edgeMarker(const graph::PoseGraph& graph, const std_msgs::Header& header,
                  const Style& style) {
  Marker marker = makeMarker(header, style.name, Marker::LINE_LIST);
  marker.scale.x = kLine;
  marker.color = style.color;
  for (const graph::Constraint& constraint : graph.constraints) {
    if (constraint.kind == style.kind) {
      marker.points.push_back(pointAt(graph.poses[constraint.from].translation(), style.height));
      marker.points.push_back(pointAt(graph.poses[constraint.to].translation(), style.height));
    }
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray graphMarkers(const graph::PoseGraph& graph,
                                             const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(nodeMarker(graph, header));
  for (const Style& style : edgeStyles()) {
    array.markers.push_back(edgeMarker(graph, header, style));
  }
  for (Marker& marker : array.markers) {
    if (marker.points.empty()) {
      marker.action = Marker::DELETE;  // rviz complains of lists without points
    }
  }
  return array;
}

}  // namespace omega_slam
