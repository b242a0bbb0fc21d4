#pragma once

#include <string>

#include "omega_slam/config/parameter_reader.h"
#include "omega_slam/simulation/route_driver.h"
#include "omega_slam/simulation/turtlebot.h"

namespace omega_slam {

/// Parameters of the node simulator; config/simulator.yaml explains them.
struct SimulatorConfig {
  std::string world;        ///< path of the world file
  double speed{1.0};        ///< simulated seconds in a real one; 0: as fast as possible
  double start_delay{1.5};  ///< [s] of wall time that the clock stands, for subscribers to connect
  std::string odom_frame{"odom"};
  std::string base_frame{"base_footprint"};
  std::string laser_frame{"laser"};
  std::string bumper_frame{"base_link"};
  std::string world_frame{"world"};  ///< of the true pose; no transform leads to it
  simulation::TurtleBotConfig robot;
};

/// Parameters of the node route_follower; config/route_follower.yaml explains them.
struct RouteFollowerConfig {
  std::string world;  ///< path of the world file, which holds the route
  simulation::RouteDriverConfig driver;
};

/// Each reads all keys and does not call finish().
void read(config::ParameterReader& reader, SimulatorConfig& config);
void read(config::ParameterReader& reader, RouteFollowerConfig& config);

}  // namespace omega_slam
