// How long detectors of frontiers take, against the size of the map. scripts/experiments runs it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "experiments/program.h"
#include "exploration/thread_timer.h"
#include "omega_slam/exploration/fast_detector.h"
#include "omega_slam/exploration/wavefront_detector.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {
namespace {

constexpr int kRoom = 100;  // [cells] from wall to wall
constexpr int kDoor = 20;   // [cells]

/// Rooms with doors to all sides, all known but for a strip along the right edge.
grid::OccupancyGrid building(int size) {
  grid::GridGeometry geometry;
  geometry.width = geometry.height = size;
  grid::OccupancyGrid map = grid::makeGrid(geometry, grid::kFree);
  const int known = size - kRoom / 2;
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const bool on_wall = (row % kRoom == 0 && col % kRoom > kDoor) ||
                           (col % kRoom == 0 && row % kRoom > kDoor) || row == 0 || col == 0 ||
                           row == size - 1;
      map.at({col, row}) =
          col >= known ? grid::kUnknown : (on_wall ? grid::kOccupied : grid::kFree);
    }
  }
  return map;
}

/// Of a Hokuyo before the edge of the known.
sensing::Sweep sweep() {
  sensing::Sweep result;
  for (int i = -341; i <= 341; ++i) {
    const double angle = i * 2.0 * geometry::kPi / 1024.0;
    result.beams.push_back(
        {4.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), sensing::BeamKind::kNoReturn});
  }
  return result;
}

/// [ms] of processor time; the median of some rounds.
double median(int rounds, const std::function<void(int)>& work) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    double seconds = 0.0;
    {
      const ThreadTimer timer(seconds);
      work(round);
    }
    times.push_back(1e3 * seconds);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void measure(int size, int rounds) {
  const grid::OccupancyGrid map = building(size);
  const exploration::MapView view(map);
  const double edge = (size - kRoom / 2) * map.geometry.resolution;
  const auto place = [&](int round) {
    return geometry::Pose2{edge - 2.0, 2.5 + 0.3 * (round % 5), 0.0};
  };
  std::size_t found = 0;
  const double wavefront = median(rounds, [&](int round) {
    found = exploration::detectByWavefront(view, place(round).translation(), 0.2).size();
  });
  exploration::FastDetector fast;
  const double everything = median(rounds, [&](int) { fast.searchAll(view); });
  const double contour = median(10 * rounds, [&](int round) {
    fast.update(view, exploration::contourOf(sweep(), place(round), view, 1));
  });
  fmt::print("{},{},{:.4f},{:.4f},{:.4f}\n", size, found, wavefront, everything, contour);
  std::fflush(stdout);
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  CLI::App app("Prints a row (CSV) for each size of a map: how long detectors of frontiers take.");
  std::vector<int> sizes{250, 500, 1000, 2000, 4000};
  int rounds = 9;
  app.add_option("--sizes", sizes, "[cells] of the edge of a square map")->delimiter(',');
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber)->capture_default_str();
  return omega_slam::experiments::runProgram(app, argc, argv, [&] {
    fmt::print("size,frontiers,wavefront,everything,fast\n");
    for (const int size : sizes) {
      omega_slam::experiments::measure(size, rounds);
    }
  });
}
