#pragma once

#include <string>

#include "omega_slam/config/parameter_reader.h"
#include "omega_slam/grid/map_file.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/motion/odometry_motion_model.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/back_end.h"
#include "omega_slam/slam/front_end.h"
#include "omega_slam/slam/loop_closer.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::config {

/// Section `motion_model` of config/slam.yaml; likewise below, one struct a node.
struct MotionModelNodeConfig {
  motion::OdometryMotionModelConfig noise;
  std::string odometry_source{
      "topic"};  ///< "topic": messages on odom; "tf": the transform odom_frame -> base_frame
  std::string odom_frame{"odom"};  ///< used where the source is tf
  std::string base_frame{"base_footprint"};
  double tf_rate{50.0};  ///< [Hz] at which tf is asked, where it is the source
  int samples{100};      ///< particles published on motion/samples; 0: none
  int seed{1};
};

struct ScanMatcherNodeConfig {
  sensing::ScanIntakeConfig intake;
  slam::FrontEndConfig front_end;
  slam::LoopCloserConfig loops;
  std::string map_frame{"map"};
  std::string base_frame{"base_footprint"};
  double odometry_wait{
      0.5};  ///< [s] a scan waits so long for the odometry of its time, then is dropped and counted
  std::vector<double> laser_pose;  ///< [m, m, rad] x y yaw of the laser in the base, where tf does
                                   ///< not say; empty: ask tf
};

struct GraphSlamNodeConfig {
  slam::BackEndConfig back_end;
  std::string map_frame{"map"};
  std::string odom_frame{"odom"};
  double transform_rate{20.0};      ///< [Hz] at which map -> odom is published
  double transform_tolerance{0.1};  ///< [s] by which it is post-dated
};

struct MapBuilderNodeConfig {
  mapping::OccupancyMapperConfig mapper;
  std::string map_frame{"map"};
  double update_interval{2.0};       ///< [s] the map is published at most so often
  bool always_send_whole_map{true};  ///< not only when it has grown, and to new subscribers
  std::string save_stem{"map"};      ///< path without ending that the service save_map writes to
  grid::MapFormat save_format;       ///< trinary shows walls and free space, others probabilities
  bool save_on_exit{false};          ///< also write there when the node ends
};

struct SlamConfig {
  MotionModelNodeConfig motion_model;
  ScanMatcherNodeConfig scan_matcher;
  GraphSlamNodeConfig graph_slam;
  MapBuilderNodeConfig map_builder;
};

/// The group of whoever takes scans in.
void readScans(ParameterReader reader, sensing::ScanIntakeConfig& config);

/// Each reads its section and does not call finish().
void read(ParameterReader& reader, MotionModelNodeConfig& config);
void read(ParameterReader& reader, ScanMatcherNodeConfig& config);
void read(ParameterReader& reader, GraphSlamNodeConfig& config);
void read(ParameterReader& reader, MapBuilderNodeConfig& config);

/// What the offline pipeline takes of it.
[[nodiscard]] slam::PipelineConfig pipelineConfig(const SlamConfig& config);

/// A file with the four sections, any of which may be absent. @throws ConfigurationError
[[nodiscard]] SlamConfig loadSlamConfig(const std::string& path);

}  // namespace omega_slam::config
