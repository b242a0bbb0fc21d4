#include "nodes/common/exploration_markers.h"

#include <fmt/format.h>

#include <array>

#include "nodes/common/conversions.h"
#include "nodes/common/markers.h"

namespace omega_slam {
namespace {

using exploration::Explorer;
using visualization_msgs::Marker;

constexpr double kHeight = 0.05;    // [m] above the map
constexpr double kCentroid = 0.12;  // [m]
constexpr double kSetAside = 0.25;  // [m]

/// Neighbours in the list are far apart in colour.
std_msgs::ColorRGBA colorOf(exploration::FrontierId id) {
  static const std::array<std_msgs::ColorRGBA, 6> colors{
      color(0.90F, 0.10F, 0.30F, 1.0F), color(0.10F, 0.60F, 0.90F, 1.0F),
      color(0.95F, 0.60F, 0.00F, 1.0F), color(0.20F, 0.70F, 0.20F, 1.0F),
      color(0.60F, 0.20F, 0.80F, 1.0F), color(0.00F, 0.60F, 0.60F, 1.0F)};
  return colors[id % colors.size()];
}

Marker cellMarker(const Explorer& explorer, const exploration::MapView& map,
                  const std_msgs::Header& header) {
  Marker marker = makeMarker(header, "frontiers", Marker::POINTS);
  marker.scale.x = map.geometry().resolution;
  marker.scale.y = map.geometry().resolution;
  for (const auto& [id, frontier] : explorer.frontiers()) {
    for (const exploration::Cell& cell : frontier.cells) {
      marker.points.push_back(pointAt(map.center(cell), kHeight));
      marker.colors.push_back(colorOf(id));
    }
  }
  return marker;
}

Marker centroidMarker(const Explorer& explorer, const std_msgs::Header& header) {
  Marker marker = makeMarker(header, "centroids", Marker::SPHERE_LIST);
  marker.scale.x = marker.scale.y = marker.scale.z = kCentroid;
  for (const auto& [id, frontier] : explorer.frontiers()) {
    marker.points.push_back(pointAt(frontier.centroid, kHeight));
    marker.colors.push_back(colorOf(id));
  }
  return marker;
}

Marker goalMarker(const exploration::Goal& goal, const std_msgs::Header& header) {
  Marker marker = makeMarker(header, "goal", Marker::ARROW);
  marker.pose = poseToRos(goal.T_map_base);
  marker.pose.position.z = kHeight;
  marker.scale.x = 0.5;
  marker.scale.y = marker.scale.z = 0.1;
  marker.color = color(0.0F, 0.8F, 0.2F, 1.0F);
  return marker;
}

Marker setAsideMarker(const exploration::SetAside& entry, int id, const std_msgs::Header& header) {
  Marker marker = makeMarker(header, "set aside", Marker::TEXT_VIEW_FACING);
  marker.id = id;
  marker.pose.position = pointAt(entry.place, kHeight);
  marker.scale.z = kSetAside;
  marker.color = color(0.8F, 0.0F, 0.0F, 1.0F);
  marker.text = fmt::format("x{}", entry.tried.size());
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray explorationMarkers(const Explorer& explorer,
                                                   const exploration::MapView& map,
                                                   const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  Marker everything = makeMarker(header, "", Marker::CUBE);
  everything.action = Marker::DELETEALL;
  array.markers.push_back(everything);
  if (!explorer.frontiers().empty()) {  // rviz complains of lists without points
    array.markers.push_back(cellMarker(explorer, map, header));
    array.markers.push_back(centroidMarker(explorer, header));
  }
  if (explorer.goal()) {
    array.markers.push_back(goalMarker(*explorer.goal(), header));
  }
  int id = 0;
  for (const exploration::SetAside& entry : explorer.setAside()) {
    array.markers.push_back(setAsideMarker(entry, id++, header));
  }
  return array;
}

}  // namespace omega_slam
