#pragma once

namespace omega_slam::geometry {

inline constexpr double kPi = 3.14159265358979323846;

/// The same angle in the half-open interval [-pi, pi). A NaN or an infinity gives NaN.
/// @param angle [rad]
[[nodiscard]] double normalizeAngle(double angle);

/// The shortest turn that leads from `from` to `to`, in [-pi, pi). Angles are never subtracted by
/// hand.
/// @param from, to [rad]
[[nodiscard]] double angleDifference(double to, double from);

[[nodiscard]] constexpr double degreesToRadians(double degrees) { return degrees * kPi / 180.0; }
[[nodiscard]] constexpr double radiansToDegrees(double radians) { return radians * 180.0 / kPi; }

}  // namespace omega_slam::geometry
