#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <string>

/// What the markers for rviz have in common.
namespace omega_slam {

/// Shares in [0, 1].
[[nodiscard]] std_msgs::ColorRGBA color(float red, float green, float blue, float alpha);

/// One to be added, at the origin of the header's frame. @param type as visualization_msgs::Marker
[[nodiscard]] visualization_msgs::Marker makeMarker(const std_msgs::Header& header,
                                                    const std::string& name, int type);

/// [m] a point of the plane at some height.
[[nodiscard]] geometry_msgs::Point pointAt(const Eigen::Vector2d& position, double height);

}  // namespace omega_slam
