#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace omega_slam::exploration {

struct ExplorerConfig {
  std::string strategy{"tour"};   ///< one of strategyNames()
  double robot_radius{0.23};      ///< [m] what is kept clear around the robot's middle
  double sensor_range{4.0};       ///< [m] up to which the laser sees walls
  double min_frontier{0.41};      ///< [m] shorter frontiers are left alone
  double decision_interval{1.0};  ///< [s] the goal is looked at anew so often
  double settle_time{2.0};        ///< [s] the map is given to show what an arrival has brought
  double set_aside_time{15.0};    ///< [s] that a frontier tried in vain is left alone
  double give_up_time{20.0};    ///< [s] without coming nearer to a goal, after which it is given up
  int max_attempts{3};          ///< viewpoints of a frontier that are tried
  int max_failures{10};         ///< goals in a row that were not reached: it is stuck
  bool return_home{true};       ///< drive back to the start in the end
  double time_budget{0.0};      ///< [s] exploring ends after so long; 0: no limit
  double distance_budget{0.0};  ///< [m] exploring ends after so much driving; 0: no limit
  std::vector<double> area;     ///< [m] x and y of each corner, map frame, of the polygon that
                                ///< frontiers must lie in; empty: anywhere
  double switch_probability{0.02};  ///< of changing sides before a step of wall following
  int seed{1};                      ///< of these changes

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

}  // namespace omega_slam::exploration
