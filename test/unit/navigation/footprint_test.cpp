#include "omega_slam/navigation/footprint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/paths.h"

namespace omega_slam::navigation {
namespace {

/// A robot of one link below its base.
std::string robot(const std::string& geometry, const std::string& origin) {
  return "<robot name='r'><link name='base'/><joint name='j' type='fixed'><parent link='base'/>"
         "<child link='body'/><origin " +
         origin + "/></joint><link name='body'><collision><geometry>" + geometry +
         "</geometry></collision></link></robot>";
}

TEST(Footprint, IsThatOfTheTurtleBot) {
  const Footprint footprint =
      readFootprint(test::sourceFolder() / "urdf/turtlebot2.urdf", "base_footprint");
  EXPECT_NEAR(footprint.inscribed_radius, 0.177, 1e-4);
  EXPECT_NEAR(footprint.circumscribed_radius, std::hypot(0.153, 0.138), 1e-4);  // the Kinect
}

TEST(Footprint, OfBoxSphereAndCylinder) {
  const Footprint box = footprintFromUrdf(robot("<box size='0.6 0.4 1'/>", "xyz='0 0 1'"), "base");
  EXPECT_NEAR(box.circumscribed_radius, std::hypot(0.3, 0.2), 1e-4);
  EXPECT_NEAR(box.inscribed_radius, 0.2, 1e-4);
  const Footprint ball =
      footprintFromUrdf(robot("<sphere radius='0.2'/>", "xyz='0.3 0 0'"), "base");
  EXPECT_NEAR(ball.circumscribed_radius, 0.5, 1e-4);
  EXPECT_EQ(ball.inscribed_radius, 0.0);  // it lies beside the point that it turns on
  // Lying on its side: as long as the cylinder, and as wide.
  const Footprint lying = footprintFromUrdf(
      robot("<cylinder radius='0.1' length='0.8'/>", "rpy='1.5707963 0 0'"), "base");
  EXPECT_NEAR(lying.circumscribed_radius, std::hypot(0.4, 0.1), 1e-4);
  EXPECT_NEAR(lying.inscribed_radius, 0.1, 1e-4);
}

TEST(Footprint, SaysWhatIsWrongWithADescription) {
  const auto complaint = [](const std::string& urdf, const std::string& base) -> std::string {
    try {
      (void)footprintFromUrdf(urdf, base);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(complaint("<robot", "base"), testing::HasSubstr("no URDF"));
  EXPECT_THAT(complaint("", "base"), testing::HasSubstr("no URDF"));
  EXPECT_THAT(complaint(robot("<sphere radius='1'/>", ""), "wheel"), testing::HasSubstr("'wheel'"));
  EXPECT_THAT(complaint(robot("<mesh filename='package://a/b.dae'/>", ""), "base"),
              testing::HasSubstr("mesh"));
  EXPECT_THAT(complaint("<robot name='r'><link name='base'/></robot>", "base"),
              testing::HasSubstr("no collision geometry"));
  EXPECT_THROW((void)readFootprint("/nowhere/at/all.urdf", "base"), std::runtime_error);
}

}  // namespace
}  // namespace omega_slam::navigation
