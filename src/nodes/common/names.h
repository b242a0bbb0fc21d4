#pragma once

/// Names of topics, services and frames that more than one node uses. All are relative: remap them,
/// or push the nodes into a namespace.
namespace omega_slam::names {

inline constexpr char kScan[] = "scan";
inline constexpr char kOdometry[] = "odom";
inline constexpr char kPrediction[] = "motion/prediction";
inline constexpr char kSamples[] = "motion/samples";
inline constexpr char kKeyframe[] = "keyframe";
inline constexpr char kConstraints[] = "constraints";
inline constexpr char kPoseGraph[] = "pose_graph";
inline constexpr char kPoseGraphMarkers[] = "pose_graph_markers";
inline constexpr char kTrajectory[] = "trajectory";
inline constexpr char kMap[] = "map";
inline constexpr char kMapMetadata[] = "map_metadata";
inline constexpr char kGroundTruth[] = "base_pose_ground_truth";

}  // namespace omega_slam::names
