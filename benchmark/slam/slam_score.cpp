#include "slam/slam_score.h"

#include <fmt/format.h>

#include <cmath>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/evaluation/trajectory_error.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/marginals.h"
#include "omega_slam/motion/odometry_buffer.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

/// Squared Mahalanobis length that one error of three in a thousand exceeds, at three degrees of
/// freedom: what three deviations are for one.
constexpr double kGate = 14.16;
constexpr double kForever = 1e12;  // [s]

/// The truth at any time.
class Truth {
 public:
  explicit Truth(const geometry::Trajectory& poses) : buffer_(kForever) {
    for (const auto& [stamp, pose] : poses) {
      buffer_.add(stamp, pose);
    }
  }

  /// At a keyframe's stamp.
  [[nodiscard]] std::optional<Pose2> at(const slam::Keyframe& keyframe) const {
    return buffer_.at(keyframe.sweep.stamp);
  }

 private:
  motion::OdometryBuffer buffer_;
};

geometry::Trajectory odometryOf(const Recording& recording) {
  geometry::Trajectory odometry;
  for (const io::ScanRecord& record : recording.records) {
    odometry.push_back({record.scan.stamp, record.T_odom_base});
  }
  return odometry;
}

bool isFar(const Pose2& error) {
  return error.translation().norm() > kLoopTranslation || std::abs(error.theta) > kLoopRotation;
}

/// By the truth, and not by its own covariance.
bool isFalse(const graph::Constraint& loop, const Pose2& T_from_to) {
  const Pose2 error = relativePose(loop.T_from_to, T_from_to);
  return isFar(error) && error.vector().dot(loop.information * error.vector()) > kGate;
}

void scoreByRelations(const Recording& recording, const SlamRun& run, SlamScore& score) {
  const auto found =
      evaluation::scoreRelations(run.trajectory, recording.relations, recording.odometry);
  score.error = found.translation.mean;
  score.error_deviation = found.translation.deviation;
  score.worst = found.translation.max;
  score.turn = found.rotation.mean;
  score.turn_deviation = found.rotation.deviation;
  score.covered = static_cast<double>(found.covered) / static_cast<double>(found.relations);
  score.odometry_error =
      evaluation::scoreRelations(odometryOf(recording), recording.relations, recording.odometry)
          .translation.mean;
}

void scoreByTruth(const Recording& recording, const SlamRun& run, SlamScore& score) {
  const auto found = evaluation::absoluteTrajectoryError(run.trajectory, recording.truth);
  score.error = found.translation.rms();
  score.error_deviation = found.translation.deviation;
  score.worst = found.translation.max;
  score.turn = found.rotation.rms();
  score.turn_deviation = found.rotation.deviation;
  score.covered =
      static_cast<double>(found.matched) / static_cast<double>(recording.records.size());
  score.odometry_error =
      evaluation::absoluteTrajectoryError(odometryOf(recording), recording.truth).translation.rms();
}

std::size_t falseLoops(const Recording& recording, const SlamRun& run) {
  const Truth truth(recording.truth);
  std::size_t found = 0;
  const auto count = [&](const graph::Constraint& loop) {
    const auto from = truth.at(*run.keyframes[loop.from]);
    const auto to = truth.at(*run.keyframes[loop.to]);
    found += from && to && isFalse(loop, relativePose(*from, *to)) ? 1 : 0;
  };
  for (std::size_t k = 0; k < run.graph.constraints.size(); ++k) {
    const graph::Constraint& loop = run.graph.constraints[k];
    const bool stands = run.weights.empty() || run.weights[k] > 0.5;
    if (loop.kind == graph::ConstraintKind::kLoop && stands) {
      count(loop);
    }
  }
  std::for_each(run.folded_loops.begin(), run.folded_loops.end(), count);
  return found;
}

void countLoops(const SlamRun& run, SlamScore& score) {
  const auto count = [&](const graph::Constraint& loop) {
    const Pose2 T_from_to = relativePose(run.graph.poses[loop.from], run.graph.poses[loop.to]);
    ++score.loops;
    score.violated += isFar(relativePose(loop.T_from_to, T_from_to)) ? 1 : 0;
  };
  for (const graph::Constraint& constraint : run.graph.constraints) {
    if (constraint.kind == graph::ConstraintKind::kLoop) {
      count(constraint);
    }
  }
  std::for_each(run.withdrawn_loops.begin(), run.withdrawn_loops.end(), count);
  std::for_each(run.folded_loops.begin(), run.folded_loops.end(), count);
  score.withdrawn = run.withdrawn_loops.size();
}

}  // namespace

SlamScore scoreRun(const Recording& recording, const SlamRun& run) {
  SlamScore score;
  score.scans = run.seconds.size();
  score.rejected = run.rejected;
  score.keyframes = run.keyframes.size();
  countLoops(run, score);
  if (!recording.truth.empty()) {
    scoreByTruth(recording, run, score);
    score.false_loops = static_cast<double>(falseLoops(recording, run));
  } else if (!recording.relations.empty()) {
    scoreByRelations(recording, run, score);
  }
  return score;
}

Honesty judgeCovariances(const Recording& recording, const SlamRun& run) {
  const Truth truth(recording.truth);
  const graph::Marginals marginals(run.graph);
  const auto start = run.keyframes.empty() ? std::nullopt : truth.at(*run.keyframes.front());
  Honesty honesty;
  if (!marginals.isValid() || !start || run.keyframes.size() < 2) {
    return honesty;
  }
  double sum = 0.0;
  double within = 0.0;
  honesty.worst_along = 0.0;
  for (std::size_t k = 1; k < run.keyframes.size(); ++k) {
    const Pose2 estimate = relativePose(run.graph.poses[0], run.graph.poses[k]);
    const Pose2 actual = relativePose(*start, truth.at(*run.keyframes[k]).value_or(*start));
    const Eigen::Vector3d error{estimate.x - actual.x, estimate.y - actual.y,
                                geometry::angleDifference(estimate.theta, actual.theta)};
    const Eigen::Matrix3d covariance = marginals.covariance(static_cast<graph::NodeId>(k));
    const double deviation = std::sqrt(covariance(0, 0));
    sum += error.dot(covariance.ldlt().solve(error)) / 3.0;
    within += std::abs(error.x()) <= 3.0 * deviation ? 1.0 : 0.0;
    if (std::abs(error.x()) > honesty.worst_along) {
      honesty.worst_along = std::abs(error.x());
      honesty.deviation_there = deviation;
    }
  }
  const auto count = static_cast<double>(run.keyframes.size() - 1);
  honesty.squared_length = sum / count;
  honesty.within = within / count;
  return honesty;
}

std::string scoreColumns() {
  return "scans,rejected,keyframes,error,error_deviation,worst,turn,turn_deviation,covered,"
         "odometry_error,loops,violated,withdrawn,false_loops";
}

std::string scoreCells(const SlamScore& score) {
  const double degrees = geometry::radiansToDegrees(1.0);
  return fmt::format("{},{},{},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{},{},{},{:g}",
                     score.scans, score.rejected, score.keyframes, score.error,
                     score.error_deviation, score.worst, score.turn * degrees,
                     score.turn_deviation * degrees, score.covered, score.odometry_error,
                     score.loops, score.violated, score.withdrawn, score.false_loops);
}

std::string honestyColumns() { return "squared_length,worst_along,deviation_there,within"; }

std::string honestyCells(const Honesty& honesty) {
  return fmt::format("{:.4g},{:.4g},{:.4g},{:.4g}", honesty.squared_length, honesty.worst_along,
                     honesty.deviation_there, honesty.within);
}

std::string costColumns() { return "cpu_seconds,median_ms,p99_ms,max_ms"; }

std::string costCells(const SlamRun& run) {
  const auto times = evaluation::summarizeTimes("scan", run.seconds);
  return fmt::format("{:.4g},{:.4g},{:.4g},{:.4g}", run.cpu_seconds, 1e3 * times.median,
                     1e3 * times.percentile_99, 1e3 * times.max);
}

}  // namespace omega_slam::experiments
