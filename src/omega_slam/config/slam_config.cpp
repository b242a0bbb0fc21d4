#include "omega_slam/config/slam_config.h"

#include "omega_slam/config/frame_name.h"
#include "omega_slam/config/yaml_file.h"

namespace omega_slam::config {
namespace {

// Beyond these, no robot that drives in a plane is described, and the number is a slip of the pen.
constexpr Range kShare{0.0, 1.0};
constexpr Range kLength{0.0, 1000.0};            // [m]
constexpr Range kPositiveLength{0.001, 1000.0};  // [m]
constexpr Range kDuration{0.0, 3600.0};          // [s]
constexpr Range kRate{0.1, 1000.0};              // [Hz]
constexpr Range kNoise{0.0, 10.0};               // standard deviation per unit of motion
constexpr Range kCount{0.0, 1000.0};
constexpr Range kPositiveCount{1.0, 1000.0};

void readLaserPose(ParameterReader& reader, std::vector<double>& laser_pose) {
  reader.read("laser_pose", laser_pose, {-kLength.max, kLength.max});
  if (!laser_pose.empty() && laser_pose.size() != 3) {
    reader.fault("laser_pose must be empty, or x, y and yaw.");
  }
}

void read(ParameterReader reader, motion::OdometryMotionModelConfig& config) {
  reader.read("rotation_per_rotation", config.rotation_per_rotation, kNoise);
  reader.read("rotation_per_translation", config.rotation_per_translation, kNoise);
  reader.read("translation_per_translation", config.translation_per_translation, kNoise);
  reader.read("translation_per_rotation", config.translation_per_rotation, kNoise);
  reader.faults(config.validate());
}

// The faults of these are found by the validate() of what they belong to.

void read(ParameterReader reader, matching::MatchConfig& config) {
  reader.read("min_returns", config.min_returns, {3.0, 10000.0});
  reader.read("outlier_distance", config.outlier_distance, kPositiveLength);
  reader.read("range_noise", config.range_noise, {0.0001, 10.0});
}

void read(ParameterReader reader, matching::SearchWindow& window) {
  reader.read("translation", window.translation, {0.0, 10.0});
  reader.read("rotation", window.rotation, {0.0, 3.15});
}

void read(ParameterReader reader, matching::CorrelativeMatcherConfig& config) {
  read(reader.group("window"), config.window);
  reader.read("resolution", config.resolution, {0.002, 1.0});
  reader.read("max_refinements", config.max_refinements, kCount);
}

void read(ParameterReader reader, matching::HillClimbingConfig& config) {
  reader.read("direction_step", config.direction_step, {0.001, 3.15});
  reader.read("distance_step", config.distance_step, kPositiveLength);
  reader.read("rotation_step", config.rotation_step, {0.001, 3.15});
  reader.read("distance_reach", config.distance_reach, kLength);
  reader.read("rotation_reach", config.rotation_reach, {0.0, 3.15});
  reader.read("shrink", config.shrink, {0.01, 1.0});
  reader.read("rounds", config.rounds, kCount);
  reader.read("error_cap", config.error_cap, kPositiveLength);
}

void read(ParameterReader reader, matching::ParticleConfig& config) {
  reader.read("particles", config.particles, {2.0, 100000.0});
  reader.read("rounds", config.rounds, kCount);
  reader.read("translation_deviation", config.translation_deviation, kPositiveLength);
  reader.read("rotation_deviation", config.rotation_deviation, {0.001, 3.15});
  reader.read("shrink", config.shrink, {0.01, 1.0});
  reader.read("space", config.space, matching::particleSpaces());
  reader.read("seed", config.seed, {0.0});
  reader.read("near_range", config.near_range, kLength);
  reader.read("max_near_share", config.max_near_share, kShare);
  reader.read("error_cap", config.error_cap, kPositiveLength);
}

void read(ParameterReader reader, matching::IcpMatcherConfig& config) {
  reader.read("max_iterations", config.max_iterations, kPositiveCount);
  reader.read("max_correspondence_distance", config.max_correspondence_distance, kPositiveLength);
}

void read(ParameterReader reader, matching::PointToLineMatcherConfig& config) {
  reader.read("max_iterations", config.max_iterations, kCount);
  reader.read("max_correspondence_distance", config.max_correspondence_distance, kPositiveLength);
}

void read(ParameterReader reader, matching::MapMatcherConfig& config) {
  reader.read("resolution", config.map.resolution, {0.005, 1.0});
  reader.read("levels", config.map.levels, {1.0, 8.0});
  reader.read("reach", config.map.reach, {1.0, 100.0});
  reader.read("max_iterations", config.max_iterations, kCount);
  reader.read("min_confidence", config.min_confidence, kShare);
}

/// Among the keys of the node itself: which matcher, and a group for each.
void read(ParameterReader& reader, matching::MatcherConfig& config) {
  reader.read("matcher", config.matcher, matching::matcherNames());
  read(reader.group("match"), config.match);
  read(reader.group("correlative"), config.correlative);
  read(reader.group("hill_climbing"), config.hill_climbing);
  read(reader.group("icp"), config.icp);
  read(reader.group("particles"), config.particles);
  read(reader.group("point_to_line"), config.point_to_line);
  read(reader.group("scan_to_map"), config.scan_to_map);
}

void read(ParameterReader reader, slam::LoopCloserConfig& config) {
  reader.read("search_radius", config.search_radius, kPositiveLength);
  reader.read("min_separation", config.min_separation, {1.0, 100000.0});
  reader.read("max_candidates", config.max_candidates, kCount);
  reader.read("neighbours", config.neighbours, kCount);
  reader.read("min_confidence", config.place.min_confidence, kShare);
  reader.read("max_contradiction", config.place.max_contradiction, kShare);
  reader.read("min_deviation", config.min_deviation, kLength);
  read(reader.group("max_window"), config.max_window);
  reader.faults(config.validate());
}

/// A kernel is the name of its kind and its width, side by side.
void readKernel(ParameterReader& reader, const std::string& key, graph::RobustKernel& kernel) {
  std::string name = graph::kernelNames().at(static_cast<std::size_t>(kernel.kind));
  reader.read(key, name, graph::kernelNames());
  kernel.kind = graph::kernelFromName(name);
  reader.read(key + "_width", kernel.width, {0.01, 1000.0});
}

void read(ParameterReader reader, slam::SurroundingsConfig& config) {
  reader.read("radius", config.radius, kPositiveLength);
  reader.read("max_deviation", config.max_deviation, kPositiveLength);
  reader.read("max_keyframes", config.max_keyframes, kPositiveCount);
}

void read(ParameterReader reader, graph::SolverConfig& config) {
  reader.read("max_iterations", config.limits.max_iterations, kPositiveCount);
  reader.read("relative_gain", config.limits.relative_gain, kShare);
  readKernel(reader, "match_kernel", config.kernels.match);
  readKernel(reader, "loop_kernel", config.kernels.loop);
}

void read(ParameterReader reader, graph::IncrementalConfig& config) {
  reader.read("batch_nodes", config.batch_nodes, {1.0, 100000.0});
  reader.read("max_turn", config.max_turn, {0.001, 3.15});
  reader.read("max_move", config.max_move, kPositiveLength);
}

void readFormat(ParameterReader& reader, grid::MapFormat& format) {
  std::string mode = grid::toString(format.mode);
  std::string image = grid::toString(format.image);
  reader.read("save_mode", mode, {"trinary", "scale", "raw"});
  reader.read("save_image", image, {"pgm", "png"});
  format.mode = grid::mapModeFromName(mode).value();
  format.image = grid::imageKindFromName(image).value();
  if (const std::string fault = format.whyNot(true); !fault.empty()) {
    reader.fault("save_image can't be pgm: " + fault);
  }
}

void readMapper(ParameterReader& reader, mapping::OccupancyMapperConfig& mapper) {
  reader.read("resolution", mapper.resolution, {0.001, 10.0});
  reader.read("max_range", mapper.max_range, kLength);
  reader.read("max_extent", mapper.max_extent, {1.0, 100000.0});
  reader.read("forget_people", mapper.forget_people);
  reader.read("occupied_threshold", mapper.rules.occupied_threshold, kShare);
  reader.read("free_threshold", mapper.rules.free_threshold, kShare);
  reader.read("min_observations", mapper.rules.min_observations, kPositiveCount);
  reader.read("prior", mapper.rules.prior, kShare);
  reader.read("prior_weight", mapper.rules.prior_weight, kCount);
  std::string renderer = mapper.renderer.kind == mapping::RendererKind::kBeam ? "beam" : "triangle";
  reader.read("renderer", renderer, {"beam", "triangle"});
  mapper.renderer.kind =
      renderer == "beam" ? mapping::RendererKind::kBeam : mapping::RendererKind::kTriangle;
  reader.read("beam_width", mapper.renderer.beam_width, {0.0, 0.5});
  reader.read("range_noise", mapper.renderer.range_noise, {0.0, 10.0});
  ParameterReader triangle = reader.group("triangle");
  triangle.read("join_all", mapper.renderer.triangle.join_all);
  triangle.read("max_range_gap", mapper.renderer.triangle.max_range_gap, kLength);
  reader.faults(mapper.validate());
}

void read(ParameterReader reader, graph::ThinningConfig& config) {
  reader.read("keyframes_per_place", config.nodes_per_place, {0.0, 100000.0});
  reader.read("spacing", config.spacing, kPositiveLength);
  reader.read("turn", config.turn, {0.001, 3.15});
  reader.read("newest", config.newest, {1.0, 100000.0});
  reader.read("max_loss", config.max_divergence, {0.0, 1000.0});
}

}  // namespace

void readScans(ParameterReader reader, sensing::ScanIntakeConfig& config) {
  reader.read("min_range", config.min_range, kLength);
  reader.read("max_range", config.max_range, kLength);
  reader.read("no_return_range", config.no_return_range, kLength);
  reader.read("nan_is_no_return", config.nan_is_no_return);
  reader.read("min_beams", config.min_beams, {1.0, 100000.0});
  reader.faults(config.validate());
}

void read(ParameterReader& reader, MotionModelNodeConfig& config) {
  reader.read("odometry_source", config.odometry_source, {"topic", "tf"});
  readFrame(reader, "odom_frame", config.odom_frame);
  readFrame(reader, "base_frame", config.base_frame);
  reader.read("tf_rate", config.tf_rate, kRate);
  reader.read("samples", config.samples, {0.0, 10000.0});
  reader.read("seed", config.seed, {0.0});
  read(reader.group("noise"), config.noise);
}

void read(ParameterReader& reader, ScanMatcherNodeConfig& config) {
  readFrame(reader, "map_frame", config.map_frame);
  readFrame(reader, "base_frame", config.base_frame);
  readLaserPose(reader, config.laser_pose);
  reader.read("odometry_wait", config.odometry_wait, kDuration);
  readScans(reader.group("scans"), config.intake);
  slam::FrontEndConfig& front_end = config.front_end;
  reader.read("keyframe_translation", front_end.keyframe_translation, kPositiveLength);
  reader.read("keyframe_rotation", front_end.keyframe_rotation, {0.001, 3.15});
  reader.read("keyframe_time", front_end.keyframe_time, kDuration);
  reader.read("min_confidence", front_end.min_confidence, kShare);
  reader.read("max_speed", front_end.max_speed, {0.01, 1000.0});
  reader.read("max_turn_rate", front_end.max_turn_rate, {0.01, 1000.0});
  reader.read("lost_distance", front_end.lost_distance, kPositiveLength);
  read(reader.group("surroundings"), front_end.surroundings);
  read(reader, front_end.matching);
  reader.faults(front_end.validate());
  config.loops.place.match = front_end.matching.match;  // it is of the laser, not of the use
  read(reader.group("loops"), config.loops);
  front_end.places = config.loops.place;  // whatever it is looked for
}

void read(ParameterReader& reader, GraphSlamNodeConfig& config) {
  readFrame(reader, "map_frame", config.map_frame);
  readFrame(reader, "odom_frame", config.odom_frame);
  reader.read("transform_rate", config.transform_rate, kRate);
  reader.read("transform_tolerance", config.transform_tolerance, kDuration);
  reader.read("solve_error", config.back_end.solve_error, {0.0, 1000.0});
  reader.read("loop_gate", config.back_end.doubt.gate, {1.0, 1000.0});
  read(reader.group("thinning"), config.back_end.thinning);
  read(reader.group("incremental"), config.back_end.graph);
  read(reader.group("solver"), config.back_end.graph.solver);
  reader.faults(config.back_end.validate());
}

void read(ParameterReader& reader, MapBuilderNodeConfig& config) {
  readFrame(reader, "map_frame", config.map_frame);
  reader.read("update_interval", config.update_interval, kDuration);
  reader.read("save_stem", config.save_stem);
  readFormat(reader, config.save_format);
  reader.read("save_on_exit", config.save_on_exit);
  if (config.save_stem.empty()) {
    reader.fault("save_stem must not be empty.");
  }
  reader.read("always_send_whole_map", config.always_send_whole_map);
  readMapper(reader, config.mapper);
}

slam::PipelineConfig pipelineConfig(const SlamConfig& config) {
  return {config.motion_model.noise, config.scan_matcher.intake, config.scan_matcher.front_end,
          config.scan_matcher.loops, config.graph_slam.back_end};
}

SlamConfig loadSlamConfig(const std::string& path) {
  ParameterReader file(loadYamlFile(path), "", path);
  SlamConfig config;
  ParameterReader motion_model = file.group("motion_model");
  read(motion_model, config.motion_model);
  ParameterReader scan_matcher = file.group("scan_matcher");
  read(scan_matcher, config.scan_matcher);
  ParameterReader graph_slam = file.group("graph_slam");
  read(graph_slam, config.graph_slam);
  ParameterReader map_builder = file.group("map_builder");
  read(map_builder, config.map_builder);
  file.finish();
  return config;
}

}  // namespace omega_slam::config
