#pragma once

#include <filesystem>
#include <string>

namespace omega_slam::navigation {

/// A robot seen from above, about the point that it turns on: the outline of all its parts.
struct Footprint {
  double inscribed_radius{0.0};      ///< [m] a disc of this is within the outline's convex hull
  double circumscribed_radius{0.0};  ///< [m] a disc of this holds the robot, however it turns
};

/// Reads the footprint off a robot's description: the collision geometry of every link that the
/// description's tree joins to the base, with all joints at zero. Spheres, cylinders and boxes, at
/// any tilt; a mesh is refused, since its file need not be here.
/// @param urdf the text; @param base_frame the link whose origin the robot turns about
/// @throws std::runtime_error with one sentence that says what is wrong
[[nodiscard]] Footprint footprintFromUrdf(const std::string& urdf, const std::string& base_frame);

/// As above from a file, which the sentence then names.
[[nodiscard]] Footprint readFootprint(const std::filesystem::path& path,
                                      const std::string& base_frame);

}  // namespace omega_slam::navigation
