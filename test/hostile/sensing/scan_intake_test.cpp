#include "omega_slam/sensing/scan_intake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::sensing {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

LaserScan goodScan() {
  LaserScan scan;
  scan.stamp = 1.0;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.01;
  scan.time_increment = 1e-4;
  scan.range_min = 0.1;
  scan.range_max = 5.0;
  scan.ranges.assign(200, 2.0F);
  return scan;
}

struct Fault {
  const char* name;
  std::function<void(LaserScan&)> inject;
  const char* rejection;  // empty: repaired
  const char* repair;     // where repaired; empty: nothing to repair
};

class ScanFaults : public testing::TestWithParam<Fault> {};

TEST_P(ScanFaults, AreRepairedOrRefusedWithAReason) {
  LaserScan scan = goodScan();
  GetParam().inject(scan);
  const auto result = ScanIntake({}).process(scan, {}, {0.01, 0.0, 0.02});
  EXPECT_EQ(result.rejection, GetParam().rejection);
  EXPECT_EQ(result.sweep.has_value(), result.rejection.empty());
  if (*GetParam().repair != '\0') {
    EXPECT_THAT(result.repairs, testing::Contains(GetParam().repair));
  } else {
    EXPECT_THAT(result.repairs, testing::IsEmpty());
  }
  if (result.sweep) {
    for (const Beam& beam : result.sweep->beams) {
      EXPECT_TRUE(beam.end.allFinite());
    }
  }
}

constexpr float kFloatNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatInf = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, ScanFaults,
    testing::Values(
        Fault{"Good", [](LaserScan&) {}, "", ""},
        Fault{"NoBeams", [](LaserScan& s) { s.ranges.clear(); }, "no beams", ""},
        Fault{"OneBeam", [](LaserScan& s) { s.ranges.resize(1); }, "", ""},
        Fault{"AllNaN", [](LaserScan& s) { s.ranges.assign(200, kFloatNaN); },
              "no beam says anything", ""},
        Fault{"AllInf", [](LaserScan& s) { s.ranges.assign(200, kFloatInf); }, "", ""},
        Fault{"AllNegativeInf", [](LaserScan& s) { s.ranges.assign(200, -kFloatInf); },
              "no beam says anything", ""},
        Fault{"AllTooClose", [](LaserScan& s) { s.ranges.assign(200, 0.01F); },
              "no beam says anything", ""},
        Fault{"NegativeRanges", [](LaserScan& s) { s.ranges.assign(200, -2.0F); },
              "no beam says anything", ""},
        Fault{"StampNaN", [](LaserScan& s) { s.stamp = kNaN; }, "stamp is not finite", ""},
        Fault{"AngleMinNaN", [](LaserScan& s) { s.angle_min = kNaN; }, "angles are not finite", ""},
        Fault{"IncrementInf", [](LaserScan& s) { s.angle_increment = kInf; },
              "angles are not finite", ""},
        Fault{"IncrementZero", [](LaserScan& s) { s.angle_increment = 0.0; },
              "angle_increment is zero", ""},
        Fault{"TwoTurns", [](LaserScan& s) { s.angle_increment = 0.0632; }, "more than a full turn",
              ""},
        Fault{"FullTurnAndOneBeam",
              [](LaserScan& s) { s.angle_increment = 2.0 * geometry::kPi / 199.0; }, "", ""},
        Fault{"RangeMinNegative", [](LaserScan& s) { s.range_min = -1.0; }, "",
              "range_min is senseless"},
        Fault{"RangeMinNaN", [](LaserScan& s) { s.range_min = kNaN; }, "",
              "range_min is senseless"},
        Fault{"RangeMaxZero", [](LaserScan& s) { s.range_max = 0.0; }, "",
              "range_max is senseless"},
        Fault{"RangeMaxInf", [](LaserScan& s) { s.range_max = kInf; }, "",
              "range_max is senseless"},
        Fault{"RangeLimitsSwapped", [](LaserScan& s) { std::swap(s.range_min, s.range_max); }, "",
              "range_max is senseless"},
        Fault{"TimeIncrementNegative", [](LaserScan& s) { s.time_increment = -1e-4; }, "",
              "time_increment is senseless"},
        Fault{"TimeIncrementHuge", [](LaserScan& s) { s.time_increment = 1.0; }, "",
              "time_increment is senseless"},
        Fault{"TimeIncrementNaN", [](LaserScan& s) { s.time_increment = kNaN; }, "",
              "time_increment is senseless"},
        Fault{"Clockwise", [](LaserScan& s) { s.angle_increment = -0.01; }, "",
              "sweeps clockwise"}),
    [](const auto& fault) { return fault.param.name; });

}  // namespace
}  // namespace omega_slam::sensing
