// How long maps take: keyframes of a simulated Hokuyo URG (683 beams) on the route of the lab, lap
// after lap. `mapping_benchmark --benchmark_out=FILE --benchmark_out_format=csv` writes entries
// that are called
//
//   add_keyframe/N         one keyframe is added to a map of N = 100, 1000, 5000, snapshot included
//   show_keyframe/N        the raster that is published is brought up to date after that
//   redraw/N               all N are drawn anew, which is what there would be without counts
//   move_tenth/N           a loop closure moves a tenth of N
//   move_all/N             a loop closure moves all of N
//   sweep/RENDERER         one sweep is drawn: beam, triangle, triangle_join_all (the paper's rule)
//   map/RENDERER           200 keyframes are drawn and rendered: beam, triangle
//   fill/METHOD            the triangles of one sweep: scan_line, cell_test (the paper's)
//   scan_alone             one keyframe is added to a map of 200 m x 200 m
//   scan_while_publishing  the same while another thread publishes that map once a second
//   memory/PEOPLE          5000 keyframes are drawn: forget_people on (forgotten) or off (kept);
//                          the label is the bytes that a keyframe takes beside its sweep
//
// each followed by "/manual_time" (or "/min_time:3.000/manual_time"). Their `real_time`, in
// `time_unit`, is what the drawing thread has spent on a processor: what else runs on the machine
// counts little. One iteration is one keyframe, update, sweep or map.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "experiments/resident_memory.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/mapping/map_raster.h"
#include "omega_slam/mapping/map_update.h"
#include "omega_slam/mapping/triangle_fill.h"
#include "omega_slam/simulation/hokuyo.h"
#include "omega_slam/simulation/world_file.h"

namespace omega_slam::experiments {
namespace {

using geometry::Pose2;
using mapping::OccupancyMapper;
using mapping::OccupancyMapperConfig;
using mapping::PlacedSweep;
using Clock = std::chrono::steady_clock;
using SweepPtr = std::shared_ptr<const sensing::Sweep>;

constexpr double kStep = 0.3;  // [m] between keyframes
constexpr double kJump = 0.2;  // [m] that a loop closure moves a keyframe

/// Time that this thread has spent on a processor [s].
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_{now()};
};

/// What the laser sees, without noise.
SweepPtr sweepFrom(const simulation::World& world, const Pose2& T_map_base) {
  const simulation::HokuyoConfig laser;
  sensing::Sweep sweep;
  sweep.angle_increment = laser.angle_increment;
  for (int k = 0; k < laser.beams; ++k) {
    const double angle = (k - laser.beams / 2) * laser.angle_increment;
    const auto hit =
        world.castRay(T_map_base.translation(), T_map_base.theta + angle, laser.range_max);
    const double range = hit ? hit->range : laser.range_max;
    sweep.beams.push_back({{range * std::cos(angle), range * std::sin(angle)},
                           hit ? sensing::BeamKind::kReturn : sensing::BeamKind::kNoReturn});
  }
  return std::make_shared<const sensing::Sweep>(sweep);
}

/// Keyframes on one lap of the world's route.
std::vector<PlacedSweep> lapOf(const simulation::LoadedWorld& world) {
  std::vector<PlacedSweep> lap;
  const std::vector<Eigen::Vector2d>& route = world.file.route;
  for (std::size_t leg = 0; leg + 1 < route.size(); ++leg) {
    const Eigen::Vector2d way = route[leg + 1] - route[leg];
    const double heading = std::atan2(way.y(), way.x());
    for (double along = 0.0; along < way.norm(); along += kStep) {
      const Eigen::Vector2d place = route[leg] + way.normalized() * along;
      const Pose2 pose{place.x(), place.y(), heading};
      lap.push_back({lap.size(), sweepFrom(*world.world, pose), pose});
    }
  }
  return lap;
}

/// As many keyframes as are wanted, lap after lap; each lap a little beside the one before.
std::vector<PlacedSweep> keyframes(const std::vector<PlacedSweep>& lap, std::size_t count) {
  std::vector<PlacedSweep> result;
  for (std::size_t k = 0; k < count; ++k) {
    PlacedSweep placed = lap[k % lap.size()];
    placed.id = k;
    placed.T_map_base.x += 0.003 * static_cast<double>(k / lap.size());
    result.push_back(placed);
  }
  return result;
}

OccupancyMapperConfig configOf(mapping::RendererKind kind, bool join_all = false) {
  OccupancyMapperConfig config;
  config.renderer.kind = kind;
  config.renderer.triangle.join_all = join_all;
  return config;
}

void addKeyframe(benchmark::State& state, const std::vector<PlacedSweep>& lap, bool is_shown) {
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<PlacedSweep> sweeps = keyframes(lap, count + 1);
  const PlacedSweep newest = sweeps.back();
  sweeps.pop_back();
  OccupancyMapper mapper;
  mapping::MapRaster raster(mapping::MapLayer::kVerdict);
  update(mapper, sweeps);
  raster.update(mapper.snapshot());
  for (auto _ : state) {
    sweeps.push_back(newest);
    Stopwatch watch;
    update(mapper, sweeps);
    const mapping::MapSnapshot snapshot = mapper.snapshot();
    if (is_shown) {
      watch = Stopwatch();
      raster.update(snapshot);
    }
    state.SetIterationTime(watch.seconds());
    sweeps.pop_back();
    update(mapper, sweeps);
    raster.update(mapper.snapshot());
  }
}

void redraw(benchmark::State& state, const std::vector<PlacedSweep>& lap) {
  const auto sweeps = keyframes(lap, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    const Stopwatch watch;
    OccupancyMapper mapper;
    update(mapper, sweeps);
    benchmark::DoNotOptimize(mapper.snapshot());
    state.SetIterationTime(watch.seconds());
  }
}

/// @param share of the keyframes that move, to and fro
void move(benchmark::State& state, const std::vector<PlacedSweep>& lap, double share) {
  auto sweeps = keyframes(lap, static_cast<std::size_t>(state.range(0)));
  OccupancyMapper mapper;
  update(mapper, sweeps);
  const auto moved = static_cast<std::size_t>(share * static_cast<double>(sweeps.size()));
  double jump = kJump;
  for (auto _ : state) {
    for (std::size_t k = sweeps.size() - moved; k < sweeps.size(); ++k) {
      sweeps[k].T_map_base.y += jump;
    }
    jump = -jump;
    const Stopwatch watch;
    update(mapper, sweeps);
    benchmark::DoNotOptimize(mapper.snapshot());
    state.SetIterationTime(watch.seconds());
  }
}

void drawSweep(benchmark::State& state, const std::vector<PlacedSweep>& lap,
               const OccupancyMapperConfig& config) {
  const auto renderer = mapping::makeRenderer(config.renderer);
  mapping::SweepRays rays;
  mapping::SweepCells cells;
  std::size_t k = 0;
  for (auto _ : state) {
    const PlacedSweep& placed = lap[k++ % lap.size()];
    const Stopwatch watch;
    benchmark::DoNotOptimize(
        mapping::placeRays(*placed.sweep, placed.T_map_base, config.resolution, 0.0, rays));
    renderer->render(rays, cells);
    benchmark::DoNotOptimize(cells.tiles().data());
    state.SetIterationTime(watch.seconds());
  }
}

void drawMap(benchmark::State& state, const std::vector<PlacedSweep>& lap,
             const OccupancyMapperConfig& config) {
  const auto sweeps = keyframes(lap, 200);
  for (auto _ : state) {
    const Stopwatch watch;
    OccupancyMapper mapper(config);
    update(mapper, sweeps);
    benchmark::DoNotOptimize(mapper.render());
    state.SetIterationTime(watch.seconds());
  }
}

void fill(benchmark::State& state, const std::vector<PlacedSweep>& lap,
          void (*fill_triangle)(const mapping::Triangle&, mapping::SweepCells&)) {
  mapping::SweepRays rays;
  mapping::SweepCells cells;
  std::size_t k = 0;
  for (auto _ : state) {
    const PlacedSweep& placed = lap[k++ % lap.size()];
    const Stopwatch watch;
    benchmark::DoNotOptimize(mapping::placeRays(*placed.sweep, placed.T_map_base, 0.05, 0.0, rays));
    cells.begin(rays.box);
    for (std::size_t ray = 1; ray < rays.rays.size(); ++ray) {
      fill_triangle({rays.start, rays.rays[ray - 1].end, rays.rays[ray].end}, cells);
    }
    benchmark::DoNotOptimize(cells.tiles().data());
    state.SetIterationTime(watch.seconds());
  }
}

/// A thread that asks for the map once a second and makes of it what is sent.
class Publisher {
 public:
  Publisher() : thread_([this] { work(); }) {}
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;
  ~Publisher() {
    is_over_ = true;
    thread_.join();
  }

  /// Called by whoever draws, after each keyframe.
  void serve(OccupancyMapper& mapper) {
    if (is_wanted_) {
      const std::lock_guard<std::mutex> lock(mutex_);
      snapshot_ = std::make_unique<mapping::MapSnapshot>(mapper.snapshot());
      is_wanted_ = false;
    }
  }

 private:
  void work() {
    mapping::MapRaster raster(mapping::MapLayer::kVerdict);
    std::vector<std::int8_t> message;
    auto next = Clock::now();
    while (!is_over_) {
      std::unique_ptr<mapping::MapSnapshot> snapshot;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        snapshot = std::move(snapshot_);
      }
      if (snapshot) {
        raster.update(*snapshot);
        message = raster.grid().cells;
        benchmark::DoNotOptimize(message.data());
        next += std::chrono::seconds(1);
      } else if (Clock::now() >= next) {
        is_wanted_ = true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  std::mutex mutex_;
  std::unique_ptr<mapping::MapSnapshot> snapshot_;
  std::atomic<bool> is_wanted_{false};
  std::atomic<bool> is_over_{false};
  std::thread thread_;  // last: everything else must exist when it begins
};

/// One keyframe after another is put into, and out of sight taken out of, a map of 200 m x 200 m.
void scan(benchmark::State& state, const std::vector<PlacedSweep>& lap, bool is_published) {
  constexpr int kSide = 50;
  constexpr double kSpacing = 4.0;  // [m]
  OccupancyMapper mapper;
  for (int k = 0; k < kSide * kSide; ++k) {
    benchmark::DoNotOptimize(mapper.add(*lap[static_cast<std::size_t>(k) % lap.size()].sweep,
                                        {kSpacing * (k % kSide), kSpacing * (k / kSide), 0.7 * k}));
  }
  const auto publisher = is_published ? std::make_unique<Publisher>() : nullptr;
  int k = 0;
  for (auto _ : state) {
    const PlacedSweep placed{1000000,
                             lap[static_cast<std::size_t>(k) % lap.size()].sweep,
                             {0.9 * (k % 200), 0.7 * (k % 277), 0.3 * k}};
    ++k;
    const Stopwatch watch;
    benchmark::DoNotOptimize(mapper.put(placed));
    if (publisher) {
      publisher->serve(mapper);
    }
    state.SetIterationTime(watch.seconds());
    mapper.takeOut(placed.id);
  }
}

/// Memory of a map, its tiles included, which are the same however people are treated.
void memory(benchmark::State& state, const std::vector<PlacedSweep>& lap, bool forget_people) {
  OccupancyMapperConfig config;
  config.forget_people = forget_people;
  const auto sweeps = keyframes(lap, 5000);
  for (auto _ : state) {
    malloc_trim(0);  // what was used before is not to be used again
    const double before = residentMemory();
    const Stopwatch watch;
    OccupancyMapper mapper(config);
    update(mapper, sweeps);
    state.SetIterationTime(watch.seconds());
    const double bytes = (residentMemory() - before) / static_cast<double>(sweeps.size());
    state.SetLabel(std::to_string(std::lround(bytes)));
  }
}

using Body = std::function<void(benchmark::State&)>;

benchmark::internal::Benchmark* declare(const std::string& name, const Body& body) {
  return benchmark::RegisterBenchmark(name.c_str(), body)
      ->Unit(benchmark::kMicrosecond)
      ->UseManualTime();
}

void declareAll(const std::vector<PlacedSweep>& lap) {
  using mapping::RendererKind;
  for (const std::int64_t count : {100, 1000, 5000}) {
    const auto withCount = [count](const std::string& name, const Body& body) {
      return declare(name, body)->Arg(count);
    };
    withCount("add_keyframe", [&](auto& s) { addKeyframe(s, lap, false); });
    withCount("show_keyframe", [&](auto& s) { addKeyframe(s, lap, true); });
    withCount("redraw", [&](auto& s) { redraw(s, lap); });
    withCount("move_tenth", [&](auto& s) { move(s, lap, 0.1); });
    withCount("move_all", [&](auto& s) { move(s, lap, 1.0); });
  }
  const OccupancyMapperConfig beam = configOf(RendererKind::kBeam);
  const OccupancyMapperConfig triangle = configOf(RendererKind::kTriangle);
  const OccupancyMapperConfig join_all = configOf(RendererKind::kTriangle, true);
  declare("sweep/beam", [&lap, beam](auto& s) { drawSweep(s, lap, beam); });
  declare("sweep/triangle", [&lap, triangle](auto& s) { drawSweep(s, lap, triangle); });
  declare("sweep/triangle_join_all", [&lap, join_all](auto& s) { drawSweep(s, lap, join_all); });
  declare("map/beam", [&lap, beam](auto& s) { drawMap(s, lap, beam); });
  declare("map/triangle", [&lap, triangle](auto& s) { drawMap(s, lap, triangle); });
  declare("fill/scan_line", [&](auto& s) { fill(s, lap, mapping::fillTriangle); });
  declare("fill/cell_test", [&](auto& s) { fill(s, lap, mapping::fillTriangleByCellTest); });
  declare("memory/forgotten", [&](auto& s) { memory(s, lap, true); })->Iterations(1);
  declare("memory/kept", [&](auto& s) { memory(s, lap, false); })->Iterations(1);
  declare("scan_alone", [&](auto& s) { scan(s, lap, false); })->MinTime(3.0);
  declare("scan_while_publishing", [&](auto& s) { scan(s, lap, true); })->MinTime(3.0);
}

}  // namespace
}  // namespace omega_slam::experiments

int main(int argc, char** argv) {
  using namespace omega_slam;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return EXIT_FAILURE;
  }
  const auto lap =
      experiments::lapOf(simulation::loadWorld(OMEGA_SLAM_SOURCE_DIR "/maps/lab.world.yaml"));
  experiments::declareAll(lap);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
