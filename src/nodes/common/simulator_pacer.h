#pragma once

namespace omega_slam {

/// Keeps simulated time in step with a wall clock that it is told, at a factor of it.
/// Where the machine is too slow, lost time is let go and not caught up with in a rush.
class SimulatorPacer {
 public:
  /// @param speed simulated seconds in a real one; 0: never wait
  /// @param patience [s] of wall time that the simulation may lag before the lag is let go
  SimulatorPacer(double speed, double patience) : speed_(speed), patience_(patience) {}

  /// From now on.
  /// @param wall [s]; @param simulated [s]
  void start(double wall, double simulated);

  /// @return [s] of wall time to wait until `simulated` is due; 0 if it is
  [[nodiscard]] double wait(double wall, double simulated);

  /// Simulated seconds in a real one since the last call, or since the start.
  [[nodiscard]] double measuredSpeed(double wall, double simulated);

  [[nodiscard]] double lostTime() const { return lost_time_; }  ///< [s] of wall time, let go so far

 private:
  double speed_;
  double patience_;
  double start_wall_{0.0};
  double start_simulated_{0.0};
  double measured_wall_{0.0};
  double measured_simulated_{0.0};
  double lost_time_{0.0};
};

}  // namespace omega_slam
