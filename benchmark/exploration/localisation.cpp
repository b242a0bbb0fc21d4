#include "exploration/localisation.h"

#include <utility>

#include "omega_slam/sensing/scan_intake.h"
#include "omega_slam/slam/pipeline.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;

class BySlam : public Localisation {
 public:
  explicit BySlam(const config::SlamConfig& config) : pipeline_(config::pipelineConfig(config)) {}

  void take(const TakenScan& taken) override {
    (void)pipeline_.process(*taken.scan, taken.mount, taken.T_odom_base, taken.motion_during_sweep);
  }
  [[nodiscard]] const std::vector<slam::KeyframePtr>& keyframes() const override {
    return pipeline_.keyframes();
  }
  [[nodiscard]] const std::vector<Pose2>& poses() const override { return pipeline_.graph().poses; }
  [[nodiscard]] std::optional<Pose2> mapFromOdom() const override {
    if (keyframes().empty()) {
      return std::nullopt;
    }
    const slam::Keyframe& newest = *keyframes().back();
    return poses()[newest.id] * newest.T_odom_base.inverse();
  }

 private:
  slam::Pipeline pipeline_;
};

class ByTruth : public Localisation {
 public:
  explicit ByTruth(const config::SlamConfig& config)
      : intake_(config.scan_matcher.intake), front_end_(config.scan_matcher.front_end) {}

  void take(const TakenScan& taken) override {
    auto [sweep, T_start_sweep, rejection, repairs] =
        intake_.process(*taken.scan, taken.mount, taken.motion_during_sweep);
    if (!sweep) {
      return;
    }
    const Pose2 T_world_base = taken.T_world_base * T_start_sweep;
    const Pose2 T_odom_base = taken.T_odom_base * T_start_sweep;
    if (keyframes_.empty()) {
      T_world_map_ = T_world_base;
    }
    const Pose2 T_map_base = relativePose(T_world_map_, T_world_base);
    T_map_odom_ = T_map_base * T_odom_base.inverse();
    if (keyframes_.empty() || isDue(T_map_base, sweep->stamp)) {
      const auto id = static_cast<graph::NodeId>(keyframes_.size());
      keyframes_.push_back(std::make_shared<const slam::Keyframe>(
          slam::Keyframe{id, T_odom_base, std::move(*sweep)}));
      poses_.push_back(T_map_base);
    }
  }
  [[nodiscard]] const std::vector<slam::KeyframePtr>& keyframes() const override {
    return keyframes_;
  }
  [[nodiscard]] const std::vector<Pose2>& poses() const override { return poses_; }
  [[nodiscard]] std::optional<Pose2> mapFromOdom() const override { return T_map_odom_; }

 private:
  [[nodiscard]] bool isDue(const Pose2& T_map_base, double stamp) const {
    return front_end_.isKeyframeDue(relativePose(poses_.back(), T_map_base),
                                    stamp - keyframes_.back()->sweep.stamp);
  }

  sensing::ScanIntake intake_;
  slam::FrontEndConfig front_end_;  ///< says when a keyframe is due
  std::vector<slam::KeyframePtr> keyframes_;
  std::vector<Pose2> poses_;
  Pose2 T_world_map_;
  std::optional<Pose2> T_map_odom_;
};

}  // namespace

std::unique_ptr<Localisation> makeLocalisation(LocalisationKind kind,
                                               const config::SlamConfig& config) {
  if (kind == LocalisationKind::kTruth) {
    return std::make_unique<ByTruth>(config);
  }
  return std::make_unique<BySlam>(config);
}

}  // namespace omega_slam::experiments
