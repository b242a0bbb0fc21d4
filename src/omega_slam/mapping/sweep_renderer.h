#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "omega_slam/mapping/sweep_cells.h"
#include "omega_slam/mapping/sweep_rays.h"

namespace omega_slam::mapping {

/// How the beams of a sweep become cells (the paper, section 6).
enum class RendererKind : std::uint8_t {
  kBeam = 0,     ///< each beam by itself
  kTriangle = 1  ///< what lies between neighbouring beams too
};

/// Which neighbouring beams have seen one surface, so that it is drawn from the end of one to the
/// end of the other.
struct TriangleConfig {
  /// The paper's plain rule: all that follow each other in the sweep have, and beams clear nothing
  /// by themselves. It draws walls across open doors.
  bool join_all{false};
  /// [m] Neighbours whose ranges differ by more have seen different things.
  double max_range_gap{0.3};
};

struct RendererConfig {
  RendererKind kind{RendererKind::kBeam};
  double beam_width{0.0};   ///< [rad] full opening angle of a beam; 0: a line. Of kBeam only.
  double range_noise{0.0};  ///< [m] standard deviation of a range. Cells nearer than two of these
                            ///< to the end of a return are not seen free.
  TriangleConfig triangle;

  [[nodiscard]] std::vector<std::string> validate() const;  ///< all violations, a sentence each
};

/// Draws single sweeps. Implementations have no state: same rays, same cells, always. That is what
/// lets a sweep be taken out of a map again.
class SweepRenderer {
 public:
  SweepRenderer() = default;
  SweepRenderer(const SweepRenderer&) = delete;
  SweepRenderer& operator=(const SweepRenderer&) = delete;
  virtual ~SweepRenderer() = default;

  /// Marks what the rays say of the cells. Cells that are both occupied and free are occupied.
  /// @param cells is overwritten
  virtual void render(const SweepRays& rays, SweepCells& cells) const = 0;
};

/// @throws std::invalid_argument if the configuration is not valid
[[nodiscard]] std::unique_ptr<SweepRenderer> makeRenderer(const RendererConfig& config);

}  // namespace omega_slam::mapping
