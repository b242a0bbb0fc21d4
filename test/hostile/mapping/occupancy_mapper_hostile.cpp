#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "omega_slam/mapping/occupancy_mapper.h"

namespace omega_slam::mapping {
namespace {

using geometry::Pose2;
using sensing::BeamKind;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

sensing::Sweep oneBeam(double x, double y) {
  sensing::Sweep sweep;
  sweep.beams.push_back({{x, y}, BeamKind::kReturn});
  return sweep;
}

/// A mapper with something in it, to see that refusals change nothing.
class OccupancyMapperHostile : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(mapper_.add(oneBeam(1.0, 0.5), {}), "");
    before_ = mapper_.render();
  }
  void TearDown() override {
    const grid::OccupancyGrid after = mapper_.render();
    EXPECT_EQ(after.cells, before_.cells);
    EXPECT_EQ(after.geometry.origin, before_.geometry.origin);
    EXPECT_EQ(after.geometry.width, before_.geometry.width);
  }
  OccupancyMapper mapper_;
  grid::OccupancyGrid before_;
};

TEST_F(OccupancyMapperHostile, PosesThatAreNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    for (const Pose2& pose : {Pose2{bad, 0, 0}, Pose2{0, bad, 0}, Pose2{0, 0, bad}}) {
      EXPECT_EQ(mapper_.add(oneBeam(1, 0), pose), "the pose of the laser in the map is not finite");
      sensing::Sweep sweep = oneBeam(1, 0);
      sweep.T_base_laser = pose;
      EXPECT_EQ(mapper_.add(sweep, {}), "the pose of the laser in the map is not finite");
    }
  }
}

TEST_F(OccupancyMapperHostile, BeamsThatAreNotFinite) {
  for (const double bad : {kNan, kInf, 1e300}) {
    EXPECT_NE(mapper_.add(oneBeam(bad, 0), {}), "");
    EXPECT_NE(mapper_.add(oneBeam(0, bad), {}), "");
  }
  EXPECT_EQ(mapper_.add(oneBeam(0, kNan), {}), "the end of a beam is not finite");
}

TEST_F(OccupancyMapperHostile, AnUnknownBeamMayBeAnything) {
  sensing::Sweep sweep;
  sweep.beams.push_back({{kNan, kInf}, BeamKind::kUnknown});
  EXPECT_EQ(mapper_.add(sweep, {}), "");
}

TEST_F(OccupancyMapperHostile, AbsurdExtents) {
  EXPECT_THAT(mapper_.add(oneBeam(1, 0), {5000.0, 0, 0}),
              HasSubstr("which is above the limit of 2000 m"));
  EXPECT_THAT(mapper_.add(oneBeam(0, -3000), {}), HasSubstr("which is above the limit of 2000 m"));
  EXPECT_THAT(mapper_.add(oneBeam(1, 0), {1500.0, 1500.0, 0}), HasSubstr("cells, which is more"));
  EXPECT_THAT(mapper_.add(oneBeam(1, 0), {1e9, 0, 0}),
              HasSubstr("m away from the origin of the map"));
  EXPECT_THAT(mapper_.add(oneBeam(1, 0), {1e200, 0, 0}), HasSubstr("away from the origin"));
}

TEST(OccupancyMapperHostileAlone, AnEmptySweepDrawsNothing) {
  OccupancyMapper mapper;
  EXPECT_EQ(mapper.add({}, {}), "");
  EXPECT_TRUE(mapper.render().cells.empty());
}

TEST(OccupancyMapperHostileAlone, StartingFarAwayIsNoProblem) {
  OccupancyMapper mapper;
  EXPECT_EQ(mapper.add(oneBeam(1, 0), {1e6, -1e6, 0.3}), "");
  EXPECT_LT(mapper.render().cells.size(), 1000U);
}

TEST(OccupancyMapperHostileAlone, BeamsOfNoLength) {
  OccupancyMapper mapper;
  EXPECT_EQ(mapper.add(oneBeam(0, 0), {}), "");
  EXPECT_EQ(mapper.render().cells, (std::vector<std::int8_t>{grid::kOccupied}));
}

TEST(OccupancyMapperHostileAlone, TheRangeLimitTamesFarReturns) {
  OccupancyMapperConfig config;
  config.max_range = 5.0;
  OccupancyMapper mapper(config);
  EXPECT_EQ(mapper.add(oneBeam(1e100, 0), {}), "");
  EXPECT_EQ(mapper.render().geometry.width, 101);
}

}  // namespace
}  // namespace omega_slam::mapping
