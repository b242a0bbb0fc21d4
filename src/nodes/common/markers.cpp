#include "nodes/common/markers.h"

namespace omega_slam {

std_msgs::ColorRGBA color(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = alpha;
  return result;
}

visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const std::string& name,
                                      int type) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

geometry_msgs::Point pointAt(const Eigen::Vector2d& position, double height) {
  geometry_msgs::Point point;
  point.x = position.x();
  point.y = position.y();
  point.z = height;
  return point;
}

}  // namespace omega_slam
