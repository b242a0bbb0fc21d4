#include "omega_slam/io/log_source.h"

#include "omega_slam/io/carmen_source.h"
#include "omega_slam/io/rover_source.h"

namespace omega_slam::io {

std::unique_ptr<ScanSource> openLog(const std::filesystem::path& path,
                                    const std::optional<geometry::Pose2>& T_base_laser) {
  if (path.extension() == ".dat") {
    RoverGeometry rover;
    rover.T_base_laser = T_base_laser.value_or(rover.T_base_laser);
    return std::make_unique<RoverSource>(path, rover);
  }
  return std::make_unique<CarmenSource>(path, T_base_laser.value_or(geometry::Pose2{}));
}

}  // namespace omega_slam::io
