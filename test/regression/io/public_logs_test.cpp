#include <gtest/gtest.h>

#include <cmath>

#include "omega_slam/graph/graph_file.h"
#include "omega_slam/io/carmen_log.h"
#include "support/paths.h"

namespace omega_slam::io {
namespace {

struct LogFacts {
  const char* file;
  std::size_t scans;
  std::size_t beams;
  std::size_t backward_stamps;
};

void PrintTo(const LogFacts& facts, std::ostream* stream) { *stream << facts.file; }

class PublicLog : public ::testing::TestWithParam<LogFacts> {};

TEST_P(PublicLog, IsReadWhole) {
  const auto path = test::dataFile(GetParam().file);
  if (!path) {
    GTEST_SKIP() << test::missingData(GetParam().file);
  }
  const CarmenLog log = readCarmenLog(*path);
  EXPECT_EQ(log.records.size(), GetParam().scans);
  EXPECT_EQ(log.backward_stamps, GetParam().backward_stamps);
  EXPECT_EQ(log.malformed_lines, 0U) << log.first_fault;
  for (const CarmenRecord& record : log.records) {
    ASSERT_EQ(record.scan.ranges.size(), GetParam().beams);
    for (const float range : record.scan.ranges) {
      ASSERT_TRUE(std::isinf(range) || range < 49.9F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, PublicLog,
    ::testing::Values(LogFacts{"logs/intel/intel_2726_fullrun_rawodom.clf", 2726, 180, 24},
                      LogFacts{"logs/intel/intel_5505_first1088s_rawodom.clf", 5505, 180, 265},
                      LogFacts{"logs/mit-csail/mit-csail.clf", 1988, 361, 0},
                      LogFacts{"logs/aces/aces_440_rawodom.clf", 440, 180, 0},
                      LogFacts{"logs/freiburg-101/freiburg-101_292_rawodom.clf", 292, 360, 0}));

struct GraphFacts {
  const char* file;
  std::size_t nodes;
  std::size_t constraints;
};

void PrintTo(const GraphFacts& facts, std::ostream* stream) { *stream << facts.file; }

class PublicGraph : public ::testing::TestWithParam<GraphFacts> {};

TEST_P(PublicGraph, IsReadWholeAndSurvivesWriting) {
  const auto path = test::dataFile(GetParam().file);
  if (!path) {
    GTEST_SKIP() << test::missingData(GetParam().file);
  }
  const graph::PoseGraph graph = graph::loadGraph(*path).graph;
  EXPECT_EQ(graph.poses.size(), GetParam().nodes);
  EXPECT_EQ(graph.constraints.size(), GetParam().constraints);
  const std::string text = graph::toG2o(graph);
  EXPECT_EQ(graph::toG2o(graph::readGraph(text, "again")), text);
}

INSTANTIATE_TEST_SUITE_P(All, PublicGraph,
                         ::testing::Values(GraphFacts{"graphs/intel.g2o", 1728, 2512},
                                           GraphFacts{"graphs/intel-carlone.g2o", 1228, 1483},
                                           GraphFacts{"graphs/MIT.g2o", 808, 827},
                                           GraphFacts{"graphs/CSAIL.g2o", 1045, 1172},
                                           GraphFacts{"graphs/manhattan.g2o", 3500, 5453},
                                           GraphFacts{"graphs/city10000.g2o", 10000, 20687}));

}  // namespace
}  // namespace omega_slam::io
