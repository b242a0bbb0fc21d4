#include "nodes/common/simulator_pacer.h"

#include <algorithm>

namespace omega_slam {

void SimulatorPacer::start(double wall, double simulated) {
  start_wall_ = measured_wall_ = wall;
  start_simulated_ = measured_simulated_ = simulated;
}

double SimulatorPacer::wait(double wall, double simulated) {
  if (speed_ <= 0.0) {
    return 0.0;
  }
  const double due = start_wall_ + (simulated - start_simulated_) / speed_;
  const double lag = wall - due;
  if (lag > patience_) {
    start_wall_ += lag;
    lost_time_ += lag;
  }
  return std::max(0.0, -lag);
}

double SimulatorPacer::measuredSpeed(double wall, double simulated) {
  const double elapsed = wall - measured_wall_;
  const double speed = elapsed > 0.0 ? (simulated - measured_simulated_) / elapsed : 0.0;
  measured_wall_ = wall;
  measured_simulated_ = simulated;
  return speed;
}

}  // namespace omega_slam
