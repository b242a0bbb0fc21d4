#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "omega_slam/geometry/pose2.h"
#include "omega_slam/motion/arc.h"
#include "omega_slam/motion/odometry_motion_model.h"

namespace omega_slam::simulation {

using motion::Arc;

struct OdometryConfig {
  motion::OdometryMotionModelConfig noise;
  double segment{0.5};            ///< [s] for which the errors stay the same
  double wheel_separation{0.23};  ///< [m] between the wheels of a Kobuki
  double wheel_radius{0.035};     ///< [m]

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// The same with all deviations multiplied by a factor >= 0.
[[nodiscard]] OdometryConfig withNoise(OdometryConfig config, double factor);

/// What the base believes of its own motion.
///
/// The odometry motion model states the error of a whole step of the robot. Drawn anew for each of
/// the 50 tiny steps of a second, independent errors would average away: n steps of 1/n of the
/// motion have 1/sqrt(n) of its deviation. So four error factors are drawn for each *segment* of
/// motion and act inside of it like a wrong wheel radius and a wrong wheel distance:
///
///     length' = length * (1 + e_tt) + |turn| * e_tr
///     turn'   = turn   * (1 + e_rr) + length * e_rt
///
/// with deviations translation_per_translation, translation_per_rotation, rotation_per_rotation
/// and sqrt(2) * rotation_per_translation (the model has two rotations, each with this error). A
/// segment that is a turn on the spot or a straight line then has exactly the deviations of the
/// model in heading and along the path; on an arc, whose turn the model splits in two halves with
/// independent errors, the part of the heading's deviation that comes from the turn is sqrt(2)
/// times the model's. Sideways, a straight segment drifts on a curve (sigma = length^2 *
/// rotation_per_translation / sqrt(2)) where the model kinks at its start.
class Odometry {
 public:
  /// @throws std::invalid_argument if the configuration is not valid
  Odometry(const OdometryConfig& config, std::uint64_t seed);

  /// @param driven the arc that was truly driven in `dt` > 0 [s]
  void advance(const Arc& driven, double dt);

  /// Back to zero, as the base's reset does; the errors go on.
  void reset();

  [[nodiscard]] const geometry::Pose2& pose() const { return T_odom_base_; }  ///< `T_odom_base`
  [[nodiscard]] double linearSpeed() const { return linear_speed_; }          ///< [m/s]
  [[nodiscard]] double angularSpeed() const { return angular_speed_; }        ///< [rad/s]

  /// Angle [rad] and speed [rad/s] of a wheel, as its encoder has it.
  struct Wheel {
    double angle{0.0};
    double speed{0.0};
  };
  [[nodiscard]] const Wheel& leftWheel() const { return left_; }
  [[nodiscard]] const Wheel& rightWheel() const { return right_; }

 private:
  void drawErrors();

  OdometryConfig config_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double segment_left_{0.0};
  double length_per_length_{0.0};
  double length_per_turn_{0.0};
  double turn_per_turn_{0.0};
  double turn_per_length_{0.0};
  geometry::Pose2 T_odom_base_;
  double linear_speed_{0.0};
  double angular_speed_{0.0};
  Wheel left_;
  Wheel right_;
};

}  // namespace omega_slam::simulation
