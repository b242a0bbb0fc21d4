#pragma once

/// Names of topics and services that more than one node uses. All are relative: remap them, or push
/// the nodes into a namespace.
namespace omega_slam::names {

inline constexpr char kScan[] = "scan";
inline constexpr char kOdometry[] = "odom";
inline constexpr char kPrediction[] = "motion/prediction";
inline constexpr char kSamples[] = "motion/samples";
inline constexpr char kTracking[] = "tracking";
inline constexpr char kTrackedPose[] = "tracked_pose";
inline constexpr char kLost[] = "lost";
inline constexpr char kKeyframe[] = "keyframe";
inline constexpr char kConstraints[] = "constraints";
inline constexpr char kPoseGraph[] = "pose_graph";
inline constexpr char kPoseGraphMarkers[] = "pose_graph_markers";
inline constexpr char kTrajectory[] = "trajectory";
inline constexpr char kMap[] = "map";
inline constexpr char kMapMetadata[] = "map_metadata";
inline constexpr char kBumper[] = "mobile_base/sensors/bumper_pointcloud";
inline constexpr char kMoveBase[] = "move_base";  ///< action
inline constexpr char kMapProbability[] = "map_probability";
inline constexpr char kMapUpdates[] = "map_updates";
inline constexpr char kGroundTruth[] = "base_pose_ground_truth";
inline constexpr char kRouteStatus[] = "route_status";  ///< "driving k/n", "done", "stuck: why"
inline constexpr char kExplorationStatus[] = "exploration_status";
inline constexpr char kExplorationMarkers[] = "exploration_markers";

inline constexpr char kDynamicMapService[] = "dynamic_map";
inline constexpr char kStaticMapService[] = "static_map";
inline constexpr char kSaveMapService[] = "save_map";
inline constexpr char kSaveGraphService[] = "save_graph";  ///< private
inline constexpr char kResetService[] = "reset";           ///< private

/// The one absolute name: the convention of REP-107, which every monitor listens to.
inline constexpr char kDiagnostics[] = "/diagnostics";

/// Messages kept for a slow subscriber. Keyframes and constraints are too precious to lose, and a
/// late subscriber is sent all of them at once; of sensor data only the newest matter.
inline constexpr unsigned kKeyframeQueue = 10000;
inline constexpr unsigned kOdometryQueue = 200;
inline constexpr unsigned kScanQueue = 20;

}  // namespace omega_slam::names
