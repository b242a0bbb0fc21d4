#include "nodes/common/simulator_pacer.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

TEST(SimulatorPacer, WaitsUntilASimulatedTimeIsDue) {
  SimulatorPacer pacer(2.0, 0.25);
  pacer.start(100.0, 1.0);
  EXPECT_NEAR(pacer.wait(100.0, 2.0), 0.5, 1e-9);
  EXPECT_NEAR(pacer.wait(100.4, 2.0), 0.1, 1e-9);
  EXPECT_NEAR(pacer.wait(100.5, 2.0), 0.0, 1e-9);
}

TEST(SimulatorPacer, NeverWaitsWhenAsFastAsPossible) {
  SimulatorPacer pacer(0.0, 0.25);
  pacer.start(100.0, 1.0);
  EXPECT_EQ(pacer.wait(100.0, 1000.0), 0.0);
  EXPECT_EQ(pacer.lostTime(), 0.0);
}

TEST(SimulatorPacer, CatchesUpWithASmallLag) {
  SimulatorPacer pacer(1.0, 0.25);
  pacer.start(0.0, 0.0);
  EXPECT_EQ(pacer.wait(1.2, 1.0), 0.0);
  EXPECT_EQ(pacer.lostTime(), 0.0);
  EXPECT_NEAR(pacer.wait(1.2, 1.5), 0.3, 1e-9);
}

TEST(SimulatorPacer, LetsGoOfALargeLag) {
  SimulatorPacer pacer(1.0, 0.25);
  pacer.start(0.0, 0.0);
  EXPECT_EQ(pacer.wait(3.0, 1.0), 0.0);
  EXPECT_NEAR(pacer.lostTime(), 2.0, 1e-9);
  EXPECT_NEAR(pacer.wait(3.0, 1.1), 0.1, 1e-9);
}

TEST(SimulatorPacer, MeasuresTheSpeedSinceItWasLastAsked) {
  SimulatorPacer pacer(5.0, 0.25);
  pacer.start(0.0, 1.0);
  EXPECT_NEAR(pacer.measuredSpeed(1.0, 6.0), 5.0, 1e-9);
  EXPECT_NEAR(pacer.measuredSpeed(2.0, 8.0), 2.0, 1e-9);
  EXPECT_EQ(pacer.measuredSpeed(2.0, 8.0), 0.0);
}

}  // namespace
}  // namespace omega_slam
