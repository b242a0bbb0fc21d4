// Which topics and frames of a bag are used, and what is said where that is not clear.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include "omega_slam/geometry/angle.h"
#include "ros_unit/bag_fixture.h"

namespace omega_slam {
namespace {

using geometry::Pose2;
using testing::HasSubstr;

class BagSources : public test::BagFixture {};

TEST_F(BagSources, LeadingSlashesOfFramesAreIgnored) {
  writer_.transform(100.0, "/base_link", "/laser", {0.2, 0.0, 0.0});
  writer_.transform(100.0, "/odom", "/base_link", Pose2{});
  writer_.transform(102.0, "/odom", "/base_link", Pose2{});
  writer_.scan(101.0, 0.0, "/laser");
  ASSERT_EQ(readAll().size(), 1U);
  EXPECT_EQ(report_.laser_frame, "laser");
}

TEST_F(BagSources, BaseIsTheFootprintWhereThereIsOne) {
  writer_.transform(100.0, "base_footprint", "base_link", {0.5, 0.0, 0.0}, "/tf_static");
  writer_.transform(100.0, "base_link", "laser", {0.2, 0.0, 0.0}, "/tf_static");
  writer_.transform(100.0, "odom", "base_footprint", Pose2{});
  writer_.transform(102.0, "odom", "base_footprint", Pose2{});
  writer_.scan(101.0);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(report_.base_frame, "base_footprint");
  EXPECT_NEAR(records[0].mount.T_base_laser.x, 0.7, 1e-9);
}

TEST_F(BagSources, BaseMayBeChosen) {
  writer_.transform(100.0, "base_footprint", "base_link", {0.5, 0.0, 0.0}, "/tf_static");
  writer_.transform(100.0, "base_link", "laser", {0.2, 0.0, 0.0}, "/tf_static");
  writer_.transform(100.0, "odom", "base_footprint", {1.0, 0.0, 0.0});
  writer_.transform(102.0, "odom", "base_footprint", {1.0, 0.0, 0.0});
  writer_.scan(101.0);
  BagLogOptions options;
  options.base_frame = "base_link";
  const auto records = readAll(options);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_NEAR(records[0].mount.T_base_laser.x, 0.2, 1e-9);
  EXPECT_NEAR(records[0].T_odom_base.x, 1.5, 1e-9);
}

TEST_F(BagSources, BaseIsWhatTheOdometryTells) {
  writer_.transform(100.0, "robot", "laser", {0.3, 0.0, 0.0});
  writer_.transform(100.0, "base_link", "laser_of_another", {0.2, 0.0, 0.0});
  writer_.odometry(100.0, Pose2{}, "robot");
  writer_.odometry(102.0, Pose2{}, "robot");
  writer_.scan(101.0);
  ASSERT_EQ(readAll().size(), 1U);
  EXPECT_EQ(report_.base_frame, "robot");
}

TEST_F(BagSources, LaserUpsideDownIsRecognised) {
  writer_.transform(100.0, "base_link", "laser", test::rolled(geometry::kPi), "/tf_static");
  drive(100.0, 102.0);
  writer_.scan(101.0);
  const auto records = readAll();
  ASSERT_EQ(records.size(), 1U);
  EXPECT_TRUE(records[0].mount.upside_down);
}

TEST_F(BagSources, TiltedLaserIsRefused) {
  writer_.transform(100.0, "base_link", "laser", test::rolled(0.3), "/tf_static");
  drive(100.0, 102.0);
  writer_.scan(101.0);
  EXPECT_THAT(refusal(), HasSubstr("tilts the laser by 0.300 rad"));
}

TEST_F(BagSources, MissingLaserTransformIsNamedWithBothFramesAndTheWayOut) {
  drive(100.0, 102.0);
  writer_.transform(100.0, "base_link", "camera", Pose2{});
  writer_.scan(101.0);
  EXPECT_THAT(refusal(),
              HasSubstr("there is no transform from the laser's frame 'laser' to the robot's base "
                        "'base_link'; say where the laser sits with --laser-pose X Y YAW. Its tf "
                        "links base_link -> camera."));
}

TEST_F(BagSources, LaserPoseTakesThePlaceOfTf) {
  drive(100.0, 102.0);
  writer_.scan(101.0);
  BagLogOptions options;
  options.laser_pose = Pose2{0.1, 0.2, 0.3};
  const auto records = readAll(options);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].mount.T_base_laser.y, 0.2);
}

TEST_F(BagSources, MissingOdometryInTfIsNamedWithBothFrames) {
  mountLaser();
  writer_.transform(101.0, "world", "base_link", Pose2{});
  writer_.scan(101.0);
  EXPECT_THAT(refusal(),
              HasSubstr("no topic of nav_msgs/Odometry, and no transform from "
                        "'base_footprint' or 'base_link' to 'odom'. Its tf links world -> "
                        "base_link, base_link -> laser."));
}

TEST_F(BagSources, SeveralLasersAreAskedAbout) {
  mountLaser();
  drive(100.0, 102.0);
  writer_.scan(101.0, 0.0, "laser", "/front");
  writer_.scan(101.0, 0.0, "laser", "/rear");
  BagLogOptions options;
  EXPECT_THAT(refusal(options), HasSubstr("there are several topics of laser scans: /front, /rear. "
                                          "Choose one with --scan-topic."));
  options.scan_topic = "rear";
  BagLog log(path_, options);
  EXPECT_EQ(log.report().scan_topic, "/rear");
}

TEST_F(BagSources, SeveralOdometriesAreAskedAboutUnlessOneIsOdom) {
  mountLaser();
  writer_.scan(101.0);
  writer_.odometry(100.0, Pose2{}, "base_link", "/ground_truth");
  writer_.odometry(100.0, Pose2{}, "base_link", "/wheels");
  EXPECT_THAT(refusal(),
              HasSubstr("there are several topics of odometry: /ground_truth, /wheels."));
}

TEST_F(BagSources, OdomIsPreferredToOtherOdometries) {
  mountLaser();
  writer_.scan(101.0);
  writer_.odometry(100.0, Pose2{}, "base_link", "/base_pose_ground_truth");
  writer_.odometry(100.0, Pose2{}, "base_link", "/odom");
  (void)readAll();
  EXPECT_EQ(report_.odometry, "/odom");
}

TEST_F(BagSources, TopicThatIsNotThereIsNamedWithThoseThatAre) {
  drive(100.0, 101.0);
  BagLogOptions options;
  options.scan_topic = "/lidar";
  EXPECT_THAT(refusal(options), HasSubstr("there is no topic /lidar of type sensor_msgs/LaserScan. "
                                          "It holds: /odom (nav_msgs/Odometry)."));
}

TEST_F(BagSources, BagWithoutScansIsNamedWithItsTopics) {
  writer_.message(100.0, "/chatter", std_msgs::String());
  EXPECT_THAT(refusal(),
              HasSubstr("there are no laser scans. It holds: /chatter (std_msgs/String)."));
}

}  // namespace
}  // namespace omega_slam
