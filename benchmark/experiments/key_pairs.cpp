#include "experiments/key_pairs.h"

#include <cmath>
#include <stdexcept>

#include "omega_slam/io/carmen_source.h"
#include "omega_slam/slam/keyframe.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr double kStep = 0.5;  // [m], [rad]
constexpr double kTurnAnyway = 0.2;
constexpr int kScansPerStep = 10;         // of a drive
constexpr double kOverstatedWay = 1.03;   // by a drive's odometry
constexpr double kOverstatedTurn = 1.05;  // likewise
constexpr std::uint32_t kStrollStream = 4;
constexpr double kRecordedDeviation = 0.02;  // [m] of a SICK's range

/// What the odometry of a drive takes a way for.
Pose2 overstated(const Pose2& way) {
  return {kOverstatedWay * way.x, kOverstatedWay * way.y, kOverstatedTurn * way.theta};
}

bool hasRoom(const Arena& arena, const Pose2& from, const Pose2& to) {
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    if (!isFree(arena, interpolate(from, to, share).translation())) {
      return false;
    }
  }
  return true;
}

Pose2 strollOn(const Arena& arena, const Pose2& T_world_base, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double drift = 0.2 * unit(random);
  const bool turn_anyway = std::abs(unit(random)) < kTurnAnyway;
  const double side = unit(random);
  const Pose2 ahead = T_world_base * Pose2{kStep * std::cos(drift), kStep * std::sin(drift), drift};
  if (!turn_anyway && hasRoom(arena, T_world_base, ahead)) {
    return ahead;
  }
  return T_world_base * Pose2{0.0, 0.0, std::copysign(kStep, side)};
}

/// For a trajectory that is better than the matches that it is to judge: nearly every scan is a
/// keyframe with constraints of its own, and loops tie it to all that it has seen before. So many
/// are taken in by small changes of the solution.
slam::PipelineConfig truthConfig() {
  slam::PipelineConfig config;
  config.front_end.keyframe_translation = 0.05;
  config.front_end.keyframe_rotation = 0.05;
  config.back_end.solve_error = 30.0;
  return config;
}

}  // namespace

KeyPairs strollPairs(const Arena& arena, std::size_t count, std::uint32_t seed) {
  auto random = generatorFor({seed, kStrollStream});
  KeyPairs found{{}, rangeDeviation};
  Pose2 place = drawFreePose(arena, random);
  matching::View view = takeScan(arena, place, random);
  for (std::size_t k = 0; k < count; ++k) {
    const Pose2 next_place = strollOn(arena, place, random);
    const matching::View next_view = takeScan(arena, next_place, random);
    found.pairs.push_back({view, next_view, relativePose(place, next_place)});
    place = next_place;
    view = next_view;
  }
  return found;
}

KeyPairs recordedPairs(const std::filesystem::path& log, std::size_t most_scans) {
  io::CarmenSource source(log, {});
  const slam::PipelineConfig config = truthConfig();
  slam::Pipeline pipeline(config);
  const sensing::ScanIntake intake(config.intake);
  std::vector<matching::View> views;
  while (views.size() < most_scans) {
    const auto record = source.next();
    if (!record) {
      break;
    }
    pipeline.process(record->scan, record->mount, record->T_odom_base);
    const auto sweep = intake.process(record->scan, record->mount).sweep;
    views.push_back(sweep ? slam::viewOf(*sweep) : matching::View{});
  }
  pipeline.finish();
  const geometry::Trajectory trajectory = pipeline.trajectory();
  if (trajectory.size() != views.size()) {
    throw std::runtime_error(log.string() + ": some of its scans have no time.");
  }
  KeyPairs found{{}, [](double /*range*/) { return kRecordedDeviation; }};
  std::size_t key = 0;
  for (std::size_t k = 1; k < views.size(); ++k) {
    const Pose2 T_key_scan = relativePose(trajectory[key].pose, trajectory[k].pose);
    if (T_key_scan.translation().norm() >= kStep || std::abs(T_key_scan.theta) >= kStep) {
      found.pairs.push_back({views[key], views[k], T_key_scan});
      key = k;
    }
  }
  return found;
}

Drive strollDrive(const Arena& arena, std::size_t most_scans, std::uint32_t seed) {
  auto random = generatorFor({seed, kStrollStream});
  Drive drive;
  Pose2 from = drawFreePose(arena, random);
  Pose2 T_odom_from;
  while (drive.views.size() < most_scans) {
    const Pose2 to = strollOn(arena, from, random);
    for (int k = 0; k < kScansPerStep && drive.views.size() < most_scans; ++k) {
      const Pose2 place = interpolate(from, to, static_cast<double>(k) / kScansPerStep);
      drive.views.push_back(takeScan(arena, place, random));
      drive.T_odom_base.push_back(T_odom_from * overstated(relativePose(from, place)));
    }
    T_odom_from = T_odom_from * overstated(relativePose(from, to));
    from = to;
  }
  return drive;
}

Drive recordedDrive(const std::filesystem::path& log, std::size_t most_scans) {
  io::CarmenSource source(log, {});
  const sensing::ScanIntake intake{{}};
  Drive drive;
  while (drive.views.size() < most_scans) {
    const auto record = source.next();
    if (!record) {
      break;
    }
    if (const auto sweep = intake.process(record->scan, record->mount).sweep) {
      drive.views.push_back(slam::viewOf(*sweep));
      drive.T_odom_base.push_back(record->T_odom_base);
    }
  }
  return drive;
}

}  // namespace omega_slam::experiments
