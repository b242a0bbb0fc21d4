#include "nodes/common/slam_conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace omega_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

slam::Keyframe makeKeyframe() {
  slam::Keyframe keyframe;
  keyframe.id = 4;
  keyframe.stretch = 2;
  keyframe.T_odom_base = {1.0, 2.0, 0.5};
  keyframe.sweep.stamp = 7.5;
  keyframe.sweep.T_base_laser = {0.1, 0.0, -0.2};
  keyframe.sweep.angle_increment = 0.01;
  keyframe.sweep.beams = {{{1.0, 0.5}, sensing::BeamKind::kReturn},
                          {{kNan, 0.0}, sensing::BeamKind::kUnknown},
                          {{4.0, 1.0}, sensing::BeamKind::kNoReturn}};
  return keyframe;
}

Keyframe makeKeyframeMessage() {
  std_msgs::Header header;
  header.stamp = ros::Time(7, 500000000);
  header.frame_id = "base_footprint";
  return keyframeToRos(makeKeyframe(), header, 99);
}

Constraint makeConstraintMessage() {
  graph::Constraint constraint;
  constraint.from = 2;
  constraint.to = 5;
  constraint.T_from_to = {0.5, -0.5, 1.0};
  constraint.information << 4.0, 1.0, 0.5, 1.0, 5.0, 0.25, 0.5, 0.25, 6.0;
  constraint.kind = graph::ConstraintKind::kLoop;
  constraint.confidence = 0.75;
  return constraintToRos(constraint);
}

TEST(SlamConversions, KeyframesComeBackAsTheyWent) {
  const Keyframe message = makeKeyframeMessage();
  EXPECT_EQ(message.run, 99U);
  EXPECT_EQ(message.header.frame_id, "base_footprint");
  const auto read = keyframeFromRos(message);
  ASSERT_TRUE(read.value) << read.fault;
  const slam::Keyframe sent = makeKeyframe();
  EXPECT_EQ(read.value->id, sent.id);
  EXPECT_EQ(read.value->stretch, sent.stretch);
  EXPECT_EQ(read.value->T_odom_base.vector(), sent.T_odom_base.vector());
  EXPECT_EQ(read.value->sweep.T_base_laser.vector(), sent.sweep.T_base_laser.vector());
  EXPECT_EQ(read.value->sweep.stamp, sent.sweep.stamp);
  EXPECT_EQ(read.value->sweep.angle_increment, sent.sweep.angle_increment);
  ASSERT_EQ(read.value->sweep.beams.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.value->sweep.beams[i].kind, sent.sweep.beams[i].kind);
  }
  EXPECT_EQ(read.value->sweep.beams[0].end, sent.sweep.beams[0].end);
  EXPECT_EQ(read.value->sweep.beams[2].end, sent.sweep.beams[2].end);
}

TEST(SlamConversions, ABeamThatSaysNothingMaySayItWithNan) {
  const auto read = keyframeFromRos(makeKeyframeMessage());
  EXPECT_TRUE(read.value->sweep.beams[1].end.allFinite());
}

TEST(SlamConversions, FaultyKeyframesAreRefusedWithTheReason) {
  const auto faultAfter = [](auto spoil) {
    Keyframe message = makeKeyframeMessage();
    spoil(message);
    const auto read = keyframeFromRos(message);
    EXPECT_EQ(read.value.has_value(), read.fault.empty());
    return read.fault;
  };
  EXPECT_EQ(faultAfter([](Keyframe&) {}), "");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.x.pop_back(); }), "keyframe lists differ in length");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.y.push_back(0.0F); }),
            "keyframe lists differ in length");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.kind.clear(); }), "keyframe lists differ in length");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.stretch = 5; }),
            "keyframe has a stretch that begins after it");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.kind[0] = 3; }), "keyframe has a beam of unknown kind");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.kind[1] = Keyframe::RETURN; }),
            "keyframe has a beam that is not finite");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.odometry.theta = kNan; }),
            "keyframe has numbers that are not finite");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.laser.x = kNan; }),
            "keyframe has numbers that are not finite");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.angle_increment = kNan; }),
            "keyframe has numbers that are not finite");
  EXPECT_EQ(faultAfter([](Keyframe& m) { m.angle_increment = 0.0; }),
            "keyframe has an angle_increment that is not positive");
}

TEST(SlamConversions, ConstraintsComeBackAsTheyWent) {
  const Constraint message = makeConstraintMessage();
  EXPECT_EQ(message.information[2], 0.5) << "row-major";
  const auto read = constraintFromRos(message);
  ASSERT_TRUE(read.value) << read.fault;
  EXPECT_EQ(read.value->from, 2U);
  EXPECT_EQ(read.value->to, 5U);
  EXPECT_EQ(read.value->T_from_to.vector(), Eigen::Vector3d(0.5, -0.5, 1.0));
  EXPECT_EQ(read.value->information(1, 2), 0.25);
  EXPECT_EQ(read.value->kind, graph::ConstraintKind::kLoop);
  EXPECT_EQ(read.value->confidence, 0.75);
}

TEST(SlamConversions, FaultyConstraintsAreRefusedWithTheReason) {
  const auto faultAfter = [](auto spoil) {
    Constraint message = makeConstraintMessage();
    spoil(message);
    const auto read = constraintFromRos(message);
    EXPECT_EQ(read.value.has_value(), read.fault.empty());
    return read.fault;
  };
  EXPECT_EQ(faultAfter([](Constraint&) {}), "");
  EXPECT_EQ(faultAfter([](Constraint& m) { m.kind = 3; }), "constraint is of unknown kind");
  EXPECT_NE(faultAfter([](Constraint& m) { m.to_id = m.from_id; }), "");
  EXPECT_NE(faultAfter([](Constraint& m) { m.pose.x = kNan; }), "");
  EXPECT_NE(faultAfter([](Constraint& m) { m.information[4] = -5.0; }), "");
  EXPECT_NE(faultAfter([](Constraint& m) { m.information[1] = 0.0; }), "") << "not symmetric";
  EXPECT_NE(faultAfter([](Constraint& m) { m.information[8] = kNan; }), "");
  for (const double confidence : {-0.1, 1.1, kNan}) {
    EXPECT_EQ(faultAfter([&](Constraint& m) { m.confidence = confidence; }),
              "constraint's confidence is not within 0 and 1");
  }
}

TEST(SlamConversions, PoseGraphsComeBackAsTheyWent) {
  graph::PoseGraph graph;
  graph.poses = {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.25}};
  graph.constraints = {graph::Constraint{}};
  graph.constraints[0].to = 1;
  const std::vector<ros::Time> stamps{ros::Time(1), ros::Time(2)};
  const PoseGraph message = poseGraphToRos(graph, stamps);
  EXPECT_EQ(message.stamps, stamps);
  const auto read = poseGraphFromRos(message);
  ASSERT_TRUE(read.value) << read.fault;
  ASSERT_EQ(read.value->poses.size(), 2U);
  EXPECT_EQ(read.value->poses[1].vector(), graph.poses[1].vector());
  EXPECT_EQ(read.value->constraints.size(), 1U);
}

TEST(SlamConversions, FaultyPoseGraphsAreRefusedWithTheReason) {
  graph::PoseGraph graph;
  graph.poses = {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.25}};
  graph.constraints = {graph::Constraint{}};
  graph.constraints[0].to = 1;
  const auto faultAfter = [&](auto spoil) {
    PoseGraph message = poseGraphToRos(graph, {ros::Time(1), ros::Time(2)});
    spoil(message);
    return poseGraphFromRos(message).fault;
  };
  EXPECT_EQ(faultAfter([](PoseGraph&) {}), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.stamps.pop_back(); }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.poses[1].y = kNan; }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.constraints[0].kind = 9; }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.constraints[0].to_id = 2; }), "");
}

TEST(SlamConversions, WhoAsksForPosesAloneIsNotConcernedByConstraints) {
  graph::PoseGraph graph;
  graph.poses = {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.25}};
  graph.constraints = {graph::Constraint{}};
  PoseGraph message = poseGraphToRos(graph, {ros::Time(1), ros::Time(2)});
  message.constraints[0].kind = 9;
  const auto read = posesFromRos(message);
  ASSERT_TRUE(read.value) << read.fault;
  ASSERT_EQ(read.value->size(), 2U);
  EXPECT_EQ(read.value->at(1).vector(), graph.poses[1].vector());
  message.poses[1].y = kNan;
  EXPECT_NE(posesFromRos(message).fault, "");
  message.poses[1].y = 0.5;
  message.stamps.pop_back();
  EXPECT_NE(posesFromRos(message).fault, "");
}

TEST(SlamConversions, RetiredKeyframesAreHeld) {
  graph::PoseGraph graph;
  graph.poses.resize(4);
  graph.held = {0, 2};
  PoseGraph message = poseGraphToRos(graph, std::vector<ros::Time>(4));
  EXPECT_EQ(message.retired, std::vector<graph::NodeId>{2});
  EXPECT_EQ(poseGraphFromRos(message).value->held, graph.held);
  message.retired = {4};
  EXPECT_NE(poseGraphFromRos(message).fault, "");
  message.retired = {0};
  EXPECT_NE(poseGraphFromRos(message).fault, "") << "the map hangs on it";
  message.retired.clear();
  EXPECT_TRUE(poseGraphFromRos(message).value->held.empty());
}

TEST(SlamConversions, BeliefsSurviveTheRoundTrip) {
  graph::PoseGraph graph;
  graph.poses.resize(3);
  graph.constraints.resize(2);
  graph.constraints[0].to = 1;
  graph.constraints[1].to = 2;
  slam::BeliefAccount beliefs{{1.0, 0.25}, {graph.constraints[1]}, {graph.constraints[0]}};
  beliefs.withdrawn[0].kind = graph::ConstraintKind::kLoop;
  const std::vector<ros::Time> stamps(3);
  const auto read = beliefsFromRos(poseGraphToRos(graph, stamps, beliefs));
  ASSERT_TRUE(read.value) << read.fault;
  EXPECT_EQ(read.value->weights, beliefs.weights);
  ASSERT_EQ(read.value->withdrawn.size(), 1U);
  EXPECT_EQ(read.value->withdrawn[0].to, 2U);
  ASSERT_EQ(read.value->folded.size(), 1U);
  EXPECT_EQ(read.value->folded[0].to, 1U);
  EXPECT_EQ(beliefsFromRos(poseGraphToRos(graph, stamps)).fault, "") << "nobody need know";
}

TEST(SlamConversions, FaultyBeliefsAreRefusedWithTheReason) {
  graph::PoseGraph graph;
  graph.poses.resize(2);
  graph.constraints.resize(1);
  graph.constraints[0].to = 1;
  const auto faultAfter = [&](auto spoil) {
    PoseGraph message = poseGraphToRos(graph, std::vector<ros::Time>(2),
                                       {{0.5}, {graph.constraints[0]}, {graph.constraints[0]}});
    spoil(message);
    return beliefsFromRos(message).fault;
  };
  EXPECT_EQ(faultAfter([](PoseGraph&) {}), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.weights.push_back(0.5); }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.weights[0] = kNan; }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.weights[0] = 1.5; }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.withdrawn[0].to_id = 2; }), "");
  EXPECT_NE(faultAfter([](PoseGraph& m) { m.folded[0].to_id = 2; }), "");
}

}  // namespace
}  // namespace omega_slam
