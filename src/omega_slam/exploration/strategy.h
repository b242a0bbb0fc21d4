#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "omega_slam/exploration/viewpoint.h"

namespace omega_slam::exploration {

/// A frontier that the robot can go and look at.
struct Option {
  FrontierId frontier{0};
  Viewpoint viewpoint;
  double gain{0.0};  ///< [m^2] unknown area that may be seen from there
  double turn{0.0};  ///< [rad] in [0, pi], between where the robot looks and where its way begins
};

/// All that a strategy decides by.
struct Situation {
  std::vector<Option> options;  ///< at least one; the order has no meaning
  geometry::Pose2 T_map_base;
  FrontierId current{0};             ///< that the robot is on its way to, and may go on to; 0: none
  Eigen::Vector2d origin{0.0, 0.0};  ///< [m] map frame, where the exploration began

  /// [m] lengths of the ways from the viewpoint of an option to those of all, in their order; where
  /// there is no way, infinity. Costs a search of the map.
  std::function<std::vector<double>(std::size_t option)> travelFrom;

  /// [m] likewise of the ways from all to where the robot is to be in the end; zeros if it may end
  /// anywhere.
  std::function<std::vector<double>()> travelHome;
};

/// Says which frontier to explore next. Deterministic.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// @return index of an option
  [[nodiscard]] virtual std::size_t choose(const Situation& situation) const = 0;

  /// Whether it wants to choose again whenever the map is new, and not only once the frontier that
  /// the robot is on its way to is gone.
  [[nodiscard]] virtual bool choosesUnderWay() const { return false; }
};

/// The option for which `cost` is least; among equals the oldest frontier.
[[nodiscard]] std::size_t cheapest(const std::vector<Option>& options,
                                   const std::function<double(const Option&)>& cost);

}  // namespace omega_slam::exploration
