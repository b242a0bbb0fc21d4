#include "omega_slam/mapping/sweep_renderer.h"

#include <fmt/format.h>

#include <stdexcept>

#include "omega_slam/mapping/beam_renderer.h"
#include "omega_slam/mapping/triangle_renderer.h"

namespace omega_slam::mapping {

std::vector<std::string> RendererConfig::validate() const {
  constexpr double kWidest = 0.5;
  std::vector<std::string> faults;
  // Written so that NaN fails too.
  if (!(beam_width >= 0.0 && beam_width <= kWidest)) {
    faults.push_back(
        fmt::format("beam_width must be in [0, {}] rad, but it is {}.", kWidest, beam_width));
  }
  if (!(range_noise >= 0.0 && range_noise <= 10.0)) {
    faults.push_back(fmt::format("range_noise must be in [0, 10] m, but it is {}.", range_noise));
  }
  if (!(triangle.max_range_gap >= 0.0 && triangle.max_range_gap <= 1000.0)) {
    faults.push_back(fmt::format("triangle/max_range_gap must be in [0, 1000] m, but it is {}.",
                                 triangle.max_range_gap));
  }
  return faults;
}

std::unique_ptr<SweepRenderer> makeRenderer(const RendererConfig& config) {
  const std::vector<std::string> faults = config.validate();
  if (!faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  if (config.kind == RendererKind::kTriangle) {
    return std::make_unique<TriangleRenderer>(config.range_noise, config.triangle);
  }
  return std::make_unique<BeamRenderer>(config.range_noise, config.beam_width);
}

}  // namespace omega_slam::mapping
