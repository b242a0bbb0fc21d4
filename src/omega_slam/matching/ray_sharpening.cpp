#include "omega_slam/matching/ray_sharpening.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "omega_slam/matching/ray_error.h"

namespace omega_slam::matching {

using geometry::Pose2;

namespace {

constexpr double kInDoubt = 0.02;  // [m], [rad] deviation from which it is worth a look
constexpr double kProbe = 0.25;    // [m], [rad] to both sides
constexpr double kReach = 0.3;     // [m], [rad] that the pose moves at most
constexpr double kDeviations = 3.0;
constexpr double kCap = 0.3;         // [m] of the difference of two rays
constexpr double kFirstStep = 0.04;  // [m], [rad] of the search
constexpr double kLastStep = 0.002;
constexpr double kFiner = 0.25;  // of the step before

/// The rays' error on a line through a pose.
class Line {
 public:
  Line(const Reference& reference, const View& scan, const Pose2& pose,
       const Eigen::Vector3d& direction)
      : reference_(reference, kCap), scan_(scan), pose_(pose), direction_(direction) {}

  /// A place on the line, and the rays' error there [m^2].
  struct Place {
    double distance;
    double error;
  };

  [[nodiscard]] Pose2 poseAt(double distance) const {
    return Pose2::fromVector(pose_.vector() + distance * direction_);
  }

  [[nodiscard]] Place at(double distance) const {
    return {distance, reference_.squaredError(scan_, poseAt(distance))};
  }

  /// By how much the error rises around a place [m^2]: to the side where it rises less, and more.
  [[nodiscard]] std::pair<double, double> risesAround(const Place& place) const {
    return std::minmax({at(place.distance - kProbe).error - place.error,
                        at(place.distance + kProbe).error - place.error});
  }

  /// Where the error is least, within a reach of where the search begins.
  [[nodiscard]] Place lowest(Place best, double reach) const {
    for (double step = kFirstStep; step > kLastStep; reach = step, step *= kFiner) {
      const double center = best.distance;
      for (double offset = -reach; offset <= reach; offset += step) {
        const Place place = at(center + offset);
        best = place.error < best.error ? place : best;
      }
    }
    return best;
  }

 private:
  RayReference reference_;
  RayScan scan_;
  Pose2 pose_;
  Eigen::Vector3d direction_;
};

}  // namespace

std::optional<Pose2> sharpenByRays(const Reference& reference, const View& scan,
                                   const MatchResult& found, const MatchConfig& config) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(found.covariance);
  const double deviation = std::sqrt(axes.eigenvalues()[2]);
  if (deviation < kInDoubt) {
    return std::nullopt;
  }
  const Eigen::Vector3d direction = axes.eigenvectors().col(2);
  const Line line(reference, scan, found.T_reference_scan, direction);
  const double noise = 2.0 * config.range_noise * config.range_noise;  // of both ranges
  const Line::Place start = line.at(0.0);
  if (line.risesAround(start).second < noise) {
    return std::nullopt;  // flat
  }
  const Line::Place bottom = line.lowest(start, std::min(kDeviations * deviation, kReach));
  // What people and doors have changed raises the bottom too; there nothing is to be built on.
  if (line.risesAround(bottom).first < noise + bottom.error) {
    return std::nullopt;
  }
  return line.poseAt(bottom.distance);
}

}  // namespace omega_slam::matching
