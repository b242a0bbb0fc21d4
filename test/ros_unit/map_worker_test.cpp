#include "nodes/common/map_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace omega_slam {
namespace {

constexpr mapping::SweepId kKeyframes = 30;
constexpr double kPatience = 30.0;  // [s]

/// A sweep with one beam of 4 m straight ahead, half a metre from the one before.
mapping::PlacedSweep placed(mapping::SweepId id) {
  sensing::Sweep sweep;
  sweep.stamp = static_cast<double>(id);
  sweep.angle_increment = 0.01;
  sweep.beams = {{{4.0, 0.0}, sensing::BeamKind::kReturn}};
  return {
      id, std::make_shared<const sensing::Sweep>(sweep), {0.0, 0.5 * static_cast<double>(id), 0.0}};
}

class MapWorkerTest : public ::testing::Test {
 protected:
  MapWorkerTest() { ros::Time::init(); }

  Diagnostics diagnostics_{"map_worker_test"};
  std::atomic<std::size_t> told_{0};
  MapWorker worker_{{}, 0.001, diagnostics_, [this](const DrawnMapPtr& map) {
                      EXPECT_FALSE(mapping::boundsOf(map->snapshot.tiles).isEmpty());
                      ++told_;
                    }};
};

TEST_F(MapWorkerTest, ManyThreadsMayShowAndRead) {
  std::atomic<bool> is_over{false};
  std::thread reader([&] {
    std::size_t before = 0;
    while (!is_over) {
      if (const auto map = worker_.newest()) {
        EXPECT_GE(map->keyframes, before);
        before = map->keyframes;
      }
      (void)diagnostics_.report(1.0);
    }
  });
  std::vector<mapping::PlacedSweep> keyframes;
  for (mapping::SweepId id = 0; id < kKeyframes; ++id) {
    keyframes.push_back(placed(id));
    worker_.show(keyframes);
    const auto map = id % 7 == 0 ? worker_.complete(kPatience) : nullptr;
    EXPECT_TRUE(!map || map->keyframes == keyframes.size());
  }
  const auto map = worker_.complete(kPatience);
  is_over = true;
  reader.join();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->keyframes, kKeyframes);
  EXPECT_EQ(map->stamp, static_cast<double>(kKeyframes - 1));
  worker_.stop();
  EXPECT_GE(told_, 1U);
}

TEST_F(MapWorkerTest, OfARunThatIsOverNoMapIsServed) {
  worker_.show({placed(0)});
  ASSERT_TRUE(worker_.complete(kPatience));
  std::thread shower([&] { worker_.show({}); });
  shower.join();
  EXPECT_FALSE(worker_.newest());
  EXPECT_FALSE(worker_.complete(kPatience));
}

TEST_F(MapWorkerTest, SimulatedTimeThatRunsFastBringsTheTurnSooner) {
  constexpr double kInterval = 3600.0;
  constexpr double kStart = 100.0;  // [s]
  ros::Time::setNow(ros::Time(kStart));
  std::atomic<std::size_t> keyframes{0};
  MapWorker worker({}, kInterval, diagnostics_,
                   [&](const DrawnMapPtr& map) { keyframes = map->keyframes; });
  const auto waitFor = [&](std::size_t count) {
    for (int look = 0; look < 1000 && keyframes != count; ++look) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return keyframes == count;
  };
  worker.show({placed(0)});
  EXPECT_TRUE(waitFor(1));
  worker.show({placed(0), placed(1)});
  ros::Time::setNow(ros::Time(kStart + 0.9 * kInterval));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(keyframes, 1U) << "its turn has not come";
  ros::Time::setNow(ros::Time(kStart + 1.1 * kInterval));
  EXPECT_TRUE(waitFor(2));
}

TEST_F(MapWorkerTest, TheStopEndsAllWaiting) {
  std::thread waiting([&] {
    for (mapping::SweepId id = 0; id < kKeyframes; ++id) {
      worker_.show({placed(id)});
      (void)worker_.complete(kPatience);
    }
  });
  worker_.stop();
  waiting.join();
  const std::size_t told = told_;
  worker_.show({placed(kKeyframes)});
  EXPECT_EQ(told_, told);
}

}  // namespace
}  // namespace omega_slam
