#include "nodes/common/scan_queue.h"

#include <gtest/gtest.h>

namespace omega_slam {
namespace {

constexpr double kPatience = 0.5;  // [s]

WaitingScan scanAt(double stamp, double arrival) {
  WaitingScan waiting;
  waiting.scan.stamp = stamp;
  waiting.end = stamp + 0.1;
  waiting.arrival = arrival;
  return waiting;
}

TEST(ScanQueue, ScansComeOutByTheirStamps) {
  ScanQueue queue(kPatience, 10);
  for (const double stamp : {3.0, 1.0, 2.0}) {
    EXPECT_FALSE(queue.push(scanAt(stamp, 0.0)));
  }
  EXPECT_EQ(queue.front().scan.stamp, 1.0);
  EXPECT_EQ(queue.pop().scan.stamp, 1.0);
  EXPECT_EQ(queue.pop().scan.stamp, 2.0);
  EXPECT_EQ(queue.pop().scan.stamp, 3.0);
  EXPECT_TRUE(queue.empty());
}

TEST(ScanQueue, WithoutRoomTheOldestIsHandedBack) {
  ScanQueue queue(kPatience, 2);
  queue.push(scanAt(1.0, 0.0));
  queue.push(scanAt(2.0, 0.0));
  const auto dropped = queue.push(scanAt(3.0, 0.0));
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->scan.stamp, 1.0);
  EXPECT_EQ(queue.front().scan.stamp, 2.0);
}

TEST(ScanQueue, AFastSimulationCostsNoScans) {
  ScanQueue queue(kPatience, 10);
  queue.push(scanAt(1.0, 100.0));
  queue.push(scanAt(60.0, 100.1));  // a minute of messages within a tenth of a second
  EXPECT_TRUE(queue.giveUp(std::nullopt, 100.2).empty());
}

TEST(ScanQueue, APausedSimulationCostsNoScans) {
  ScanQueue queue(kPatience, 10);
  queue.push(scanAt(1.0, 100.0));
  EXPECT_TRUE(queue.giveUp(1.05, 105.0).empty());
}

TEST(ScanQueue, AScanIsGivenUpWhenBothClocksHaveRunOut) {
  ScanQueue queue(kPatience, 10);
  queue.push(scanAt(1.0, 100.0));
  queue.push(scanAt(1.2, 100.0));
  const auto given_up = queue.giveUp(1.7, 100.6);
  ASSERT_EQ(given_up.size(), 1U);
  EXPECT_EQ(given_up[0].scan.stamp, 1.0);
  EXPECT_EQ(queue.front().scan.stamp, 1.2);
}

TEST(ScanQueue, NewerScansTellTheTimeWhereThereIsNoOdometry) {
  ScanQueue queue(kPatience, 10);
  queue.push(scanAt(1.0, 100.0));
  queue.push(scanAt(2.0, 101.0));
  EXPECT_EQ(queue.giveUp(std::nullopt, 101.0).size(), 1U);
}

TEST(ScanQueue, AScanFromTheFarFutureDoesNotStayForEver) {
  ScanQueue queue(kPatience, 10);
  queue.push(scanAt(1e9, 100.0));
  EXPECT_TRUE(queue.giveUp(1.0, 101.0).empty());
  EXPECT_EQ(queue.giveUp(10.0, 111.0).size(), 1U);
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.giveUp(10.0, 111.0).empty());
}

}  // namespace
}  // namespace omega_slam
