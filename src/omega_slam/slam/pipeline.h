#pragma once

#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/mapping/occupancy_mapper.h"
#include "omega_slam/motion/motion_predictor.h"
#include "omega_slam/sensing/frozen_laser.h"
#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/back_end.h"
#include "omega_slam/slam/front_end.h"
#include "omega_slam/slam/loop_closer.h"
#include "omega_slam/slam/scan_trajectory.h"

namespace omega_slam::slam {

struct PipelineConfig {
  motion::OdometryMotionModelConfig noise;
  sensing::ScanIntakeConfig intake;
  FrontEndConfig front_end;
  LoopCloserConfig loops;
  BackEndConfig back_end;
};

/// What one scan has led to; facts for the caller to count.
struct ScanOutcome {
  std::string rejection;             ///< as ScanIntakeResult
  std::vector<std::string> repairs;  ///< as ScanIntakeResult
  bool keyframe{false};
  bool match_untrusted{false};  ///< a match was tried, and the odometry was left alone
  bool is_lost{false};          ///< as FrontEndResult
  std::size_t loops{0};         ///< loop constraints found
};

/// The whole chain wired by function calls: the same objects that the nodes wire by topics.
/// Deterministic: same calls, same results. Not thread-safe.
class Pipeline {
 public:
  explicit Pipeline(const PipelineConfig& config = {});  ///< @throws std::invalid_argument

  /// @param T_odom_start odometry at the scan's stamp
  /// @param motion_during_sweep see ScanIntake::process
  ScanOutcome process(const sensing::LaserScan& scan, const sensing::LaserMount& mount,
                      const geometry::Pose2& T_odom_start,
                      const geometry::Pose2& motion_during_sweep = {});

  /// The last solve, of everything. Call it once, after the last scan.
  const graph::SolveReport& finish();

  [[nodiscard]] const graph::PoseGraph& graph() const { return back_end_.graph(); }
  /// BackEnd::withdrawn()
  [[nodiscard]] const std::vector<graph::Constraint>& withdrawnLoops() const {
    return back_end_.withdrawn();
  }
  /// BeliefAccount::folded
  [[nodiscard]] const std::vector<graph::Constraint>& foldedLoops() const {
    return back_end_.folded();
  }
  /// FrontEnd::odometryFaults()
  [[nodiscard]] OdometryFaults odometryFaults() const { return front_end_.odometryFaults(); }
  [[nodiscard]] std::size_t retiredKeyframes() const { return back_end_.retired(); }
  [[nodiscard]] const std::vector<KeyframePtr>& keyframes() const { return keyframes_; }

  /// One pose `T_map_base` for every scan that came with a finite stamp, in their order, at the
  /// middle of its sweep. Between two keyframes what was tracked is bent so that it fits both.
  [[nodiscard]] geometry::Trajectory trajectory() const;

  /// The map that the keyframes give at their solved poses.
  [[nodiscard]] grid::OccupancyGrid map(const mapping::OccupancyMapperConfig& config) const;

 private:
  [[nodiscard]] geometry::Pose2 carriedOn(const geometry::Pose2& T_odom_base) const;
  void addKeyframe(const FrontEndResult& result, ScanOutcome& outcome);

  sensing::ScanIntake intake_;
  sensing::FrozenLaser frozen_laser_;
  motion::MotionPredictor predictor_;
  FrontEnd front_end_;
  LoopCloser loops_;
  BackEnd back_end_;
  std::vector<KeyframePtr> keyframes_;
  std::vector<ScanTrack> tracks_;
  geometry::Pose2 T_odom_tracked_;      ///< odometry at the last scan that was tracked
  geometry::Pose2 T_keyframe_tracked_;  ///< where that was, seen from the newest keyframe
};

}  // namespace omega_slam::slam
