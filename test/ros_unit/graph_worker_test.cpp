#include "nodes/common/graph_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

namespace omega_slam {
namespace {

using geometry::Pose2;
using std::chrono::seconds;

constexpr graph::NodeId kKeyframes = 60;

KeyframeArrival keyframe(std::uint64_t run, graph::NodeId id) {
  return {run, id, ros::Time(1.0 + id), Pose2{0.5 * id, 0.0, 0.0}};
}

ConstraintArrival tie(std::uint64_t run, graph::NodeId from, graph::NodeId to,
                      graph::ConstraintKind kind = graph::ConstraintKind::kOdometry) {
  graph::Constraint constraint;
  constraint.from = from;
  constraint.to = to;
  constraint.T_from_to = {0.5 * (to - from), 0.0, 0.0};
  constraint.kind = kind;
  return {run, {constraint}};
}

class GraphWorkerTest : public ::testing::Test {
 protected:
  GraphWorkerTest() { ros::Time::init(); }

  /// Takes in snapshots, each of which must be whole.
  GraphWorker::Changed take() {
    return [this](const GraphSnapshotPtr& snapshot) {
      expectWhole(*snapshot);
      const std::lock_guard<std::mutex> lock(mutex_);
      last_ = snapshot;
      ++calls_;
      told_.notify_all();
    };
  }

  static void expectWhole(const GraphSnapshot& snapshot) {
    EXPECT_EQ(snapshot.stamps.size(), snapshot.graph.poses.size());
    EXPECT_EQ(snapshot.beliefs.weights.size(), snapshot.graph.constraints.size());
    for (const graph::Constraint& constraint : snapshot.graph.constraints) {
      EXPECT_LT(constraint.to, snapshot.graph.poses.size());
    }
  }

  [[nodiscard]] bool waitFor(std::uint64_t run, std::size_t poses, std::size_t constraints) {
    std::unique_lock<std::mutex> lock(mutex_);
    return told_.wait_for(lock, seconds(30), [&] {
      return last_ && last_->run == run && last_->graph.poses.size() == poses &&
             last_->graph.constraints.size() == constraints;
    });
  }

  /// Everything about one run, from three threads at once.
  static void drive(GraphWorker& worker, std::uint64_t run) {
    std::thread keyframes([&] {
      for (graph::NodeId id = 0; id < kKeyframes; ++id) {
        worker.add(keyframe(run, id));
      }
    });
    std::thread steps([&] {
      for (graph::NodeId id = 1; id < kKeyframes; ++id) {
        worker.add(tie(run, id - 1, id));
      }
    });
    for (graph::NodeId id = 20; id < kKeyframes; id += 5) {
      worker.add(tie(run, id - 20, id, graph::ConstraintKind::kLoop));
    }
    keyframes.join();
    steps.join();
  }
  static constexpr std::size_t kConstraints = kKeyframes - 1 + (kKeyframes - 20) / 5;

  Diagnostics diagnostics_{"graph_worker_test"};
  std::mutex mutex_;
  std::condition_variable told_;
  GraphSnapshotPtr last_;
  std::size_t calls_{0};
};

TEST_F(GraphWorkerTest, ManyThreadsMayPostAndRead) {
  GraphWorker worker({}, diagnostics_, take());
  std::atomic<bool> is_over{false};
  std::thread reader([&] {
    std::size_t before = 0;
    while (!is_over) {
      if (const auto snapshot = worker.snapshot()) {
        expectWhole(*snapshot);
        EXPECT_GE(snapshot->graph.poses.size(), before);
        before = snapshot->graph.poses.size();
      }
      (void)diagnostics_.report(1.0);
    }
  });
  drive(worker, 1);
  EXPECT_TRUE(waitFor(1, kKeyframes, kConstraints));
  is_over = true;
  reader.join();
  EXPECT_NEAR(worker.snapshot()->graph.poses.back().x, 0.5 * (kKeyframes - 1), 1e-6);
}

TEST_F(GraphWorkerTest, AResetWhileMessagesComeLeavesRoomForTheNextRun) {
  GraphWorker worker({}, diagnostics_, take());
  std::thread first([&] { drive(worker, 1); });
  for (int i = 0; i < 20; ++i) {
    worker.reset();
  }
  first.join();
  worker.reset();
  drive(worker, 2);
  EXPECT_TRUE(waitFor(2, kKeyframes, kConstraints));
}

/// However long a solve and its publication take.
TEST_F(GraphWorkerTest, CallbacksNeverWaitForTheWorker) {
  std::promise<void> begun;
  std::promise<void> gate;
  std::once_flag once;
  GraphWorker worker({}, diagnostics_, [&](const GraphSnapshotPtr& snapshot) {
    std::call_once(once, [&] {
      begun.set_value();
      gate.get_future().wait();
    });
    take()(snapshot);
  });
  worker.add(keyframe(1, 0));
  begun.get_future().wait();
  std::future<void> callbacks = std::async(std::launch::async, [&] {
    drive(worker, 1);
    EXPECT_EQ(worker.snapshot()->graph.poses.size(), 1U);
  });
  const auto state = callbacks.wait_for(seconds(30));
  gate.set_value();
  EXPECT_EQ(state, std::future_status::ready);
  callbacks.get();
  EXPECT_TRUE(waitFor(1, kKeyframes, kConstraints));
}

TEST_F(GraphWorkerTest, AfterTheStopNobodyIsTold) {
  GraphWorker worker({}, diagnostics_, take());
  std::thread messages([&] { drive(worker, 1); });
  worker.stop();
  const std::size_t calls = calls_;
  messages.join();
  worker.add(keyframe(1, kKeyframes));
  worker.stop();
  EXPECT_EQ(calls_, calls);
}

}  // namespace
}  // namespace omega_slam
