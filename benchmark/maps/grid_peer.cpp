#include "maps/grid_peer.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cpu_timer.h"
#include "experiments/csv_file.h"
#include "maps/map_scores.h"
#include "maps/standing_scans.h"
#include "omega_slam/evaluation/cell_mask.h"
#include "omega_slam/sensing/scan_intake.h"

namespace omega_slam::experiments {
namespace {

constexpr std::size_t kScans = 1000;
constexpr int kRounds = 3;

/// How far two maps say the same of the cells that both know.
struct Agreement {
  std::size_t both{0};    ///< cells that both know
  std::size_t either{0};  ///< cells that one of them knows
  std::size_t alike{0};   ///< of `both`, those of which they say the same

  Agreement(const grid::OccupancyGrid& a, const grid::OccupancyGrid& b) {
    evaluation::forEachCell(a.geometry, [&](const grid::Cell& cell) {
      const grid::Cell other = b.geometry.cellAt(a.geometry.center(cell));
      const bool knows = a.at(cell) != grid::kUnknown;
      const bool other_knows = b.geometry.contains(other) && b.at(other) != grid::kUnknown;
      either += knows || other_knows ? 1U : 0U;
      both += knows && other_knows ? 1U : 0U;
      alike += knows && other_knows && a.at(cell) == b.at(other) ? 1U : 0U;
    });
  }
};

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<PlacedSweep> sweepsOf(const std::vector<StandingScan>& scans,
                                  const sensing::LaserMount& mount) {
  std::vector<PlacedSweep> sweeps;
  for (const StandingScan& taken : scans) {
    if (const auto result = sensing::ScanIntake({}).process(taken.scan, mount); result.sweep) {
      sweeps.push_back({*result.sweep, taken.T_map_base});
    }
  }
  return sweeps;
}

TimedMap drawByUs(const std::vector<PlacedSweep>& sweeps, const mapping::RendererConfig& renderer,
                  bool forget_people = true) {
  const CpuTimer timer;
  TimedMap drawn{drawMap(sweeps, renderer, forget_people), 0.0};
  drawn.seconds = timer.seconds();
  return drawn;
}

/// The true map's area in cells that are counted from the origin, as our maps' are.
grid::GridGeometry areaOf(const grid::OccupancyGrid& truth) {
  constexpr int kMargin = 100;  // [cells] that a beam may reach outside
  grid::GridGeometry area = truth.geometry;
  const grid::Cell corner = (truth.geometry.origin / area.resolution).array().floor().cast<int>();
  area.origin = area.resolution * (corner.array() - kMargin).cast<double>().matrix();
  area.width += 2 * kMargin;
  area.height += 2 * kMargin;
  return area;
}

}  // namespace

void runGridPeer(const Site& site, std::uint64_t seed, const std::filesystem::path& folder) {
  const sensing::LaserMount mount{simulation::TurtleBotConfig{}.T_base_laser, false};
  const std::vector<StandingScan> scans = takeStandingScans(site, kScans, seed);
  const std::vector<PlacedSweep> sweeps = sweepsOf(scans, mount);
  CsvFile table(folder / ("peer_" + site.name + ".csv"),
                "site,drawn_by,scans,microseconds,alike,known_by_both,resemblance,wall_precision,"
                "wall_recall");
  const grid::OccupancyGrid ours = drawMap(sweeps, {});
  const auto enter = [&](const std::string& name, const auto& draw) {
    std::optional<TimedMap> best = draw();
    for (int round = 1; best && round < kRounds; ++round) {
      best->seconds = std::min(best->seconds, draw()->seconds);
    }
    if (best) {
      const Agreement agreement(best->map, ours);
      const auto found =
          evaluation::compareMaps(best->map, site.truth, {{}, site.world.file.start.translation()});
      table.row(site.name, name, scans.size(),
                1e6 * best->seconds / static_cast<double>(scans.size()),
                share(agreement.alike, agreement.both), share(agreement.both, agreement.either),
                found.score(), found.wallPrecision(), found.wallRecall());
    }
  };
  for (const NamedRenderer& renderer : renderers()) {
    enter(renderer.name, [&] { return std::make_optional(drawByUs(sweeps, renderer.config)); });
  }
  enter("beam_keeping_people", [&] { return std::make_optional(drawByUs(sweeps, {}, false)); });
  enter("mrpt", [&] { return drawByMrpt(scans, mount, areaOf(site.truth)); });
}

}  // namespace omega_slam::experiments
