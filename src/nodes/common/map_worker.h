#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "nodes/common/diagnostics.h"
#include "omega_slam/mapping/map_snapshot.h"
#include "omega_slam/mapping/occupancy_mapper.h"

namespace omega_slam {

/// A map, and what it was drawn from. Never changes, so it is shared freely between threads.
struct DrawnMap {
  mapping::MapSnapshot snapshot;
  double stamp{0.0};         ///< [s] of the newest keyframe in it
  std::size_t keyframes{0};  ///< in it
};

using DrawnMapPtr = std::shared_ptr<const DrawnMap>;

/// Draws the map in a thread of its own, which alone owns the mapper: drawing, however long,
/// holds no lock and blocks no callback. Only the newest keyframes and poses count; those that come
/// while it draws replace each other. Thread-safe.
class MapWorker {
 public:
  /// Told of every new map, in the worker's thread.
  using Drawn = std::function<void(const DrawnMapPtr&)>;

  /// @param interval [s] between the begins of two drawings, at least; of simulated time where it
  /// runs faster than the wall's
  /// @param diagnostics must outlive the worker
  /// @throws std::invalid_argument if the configuration is not valid
  MapWorker(const mapping::OccupancyMapperConfig& config, double interval, Diagnostics& diagnostics,
            Drawn drawn);
  ~MapWorker();
  MapWorker(const MapWorker&) = delete;
  MapWorker& operator=(const MapWorker&) = delete;

  /// The sweeps of all keyframes that the map is to show, where they are to be. None: there is no
  /// map.
  void show(std::vector<mapping::PlacedSweep> keyframes);

  /// The newest map, complete or not; null while there is none.
  [[nodiscard]] DrawnMapPtr newest() const;
  /// The map of all that was shown before this call, drawn at once. Waits for it.
  /// @param patience [s] after which the newest map will do
  [[nodiscard]] DrawnMapPtr complete(double patience);

  void stop();  ///< after the drawing that is going on

 private:
  using Clock = std::chrono::steady_clock;
  void work();
  /// Waits for keyframes and for their turn. @return whether to go on
  bool take(std::vector<mapping::PlacedSweep>& keyframes, std::uint64_t& version);
  void waitForTurn(std::unique_lock<std::mutex>& lock);
  /// @return the map; null if there is nothing on it
  [[nodiscard]] DrawnMapPtr draw(const std::vector<mapping::PlacedSweep>& keyframes);

  const double interval_;  ///< [s]
  Diagnostics& diagnostics_;
  Drawn drawn_;
  // Of the thread alone.
  mapping::OccupancyMapper mapper_;
  Clock::time_point next_turn_{};
  double next_simulated_turn_{0.0};  ///< [s]
  // Shared.
  mutable std::mutex mutex_;
  std::condition_variable wake_;      ///< the thread
  std::condition_variable finished_;  ///< wakes who waits for a map
  std::vector<mapping::PlacedSweep> keyframes_;
  std::uint64_t version_{0};        ///< of keyframes_
  std::uint64_t drawn_version_{0};  ///< that newest_ shows
  DrawnMapPtr newest_;
  bool is_urgent_{false};
  bool is_stopped_{false};
  std::thread thread_;  ///< last: everything else must exist when it begins
};

}  // namespace omega_slam
