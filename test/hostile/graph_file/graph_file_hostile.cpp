#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "omega_slam/graph/graph_file.h"
#include "support/graph_file_laws.h"
#include "support/paths.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::graph {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(readGraph(text, "bad.g2o"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(GraphFileHostile, FaultsNameFileLineAndReason) {
  const std::string two = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";
  struct Row {
    const char* line;
    const char* says;
  };
  const Row rows[] = {
      {"VERTEX_SE2 1 5 5 5", "bad.g2o:3: VERTEX_SE2: node 1 was there before."},
      {"VERTEX_SE2", "bad.g2o:3: VERTEX_SE2: an id is missing or not a whole number"},
      {"VERTEX_SE2 x 0 0 0", "an id is missing or not a whole number"},
      {"VERTEX_SE2 -1 0 0 0", "an id is missing or not a whole number"},
      {"VERTEX_SE2 4294967296 0 0 0", "an id is missing or not a whole number"},
      {"VERTEX_SE2 2.5 0 0", "an id is missing or not a whole number"},
      {"VERTEX_SE2 2 0.5.5 0", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0-1 0", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0 0", "bad.g2o:3: VERTEX_SE2: a field is missing or not a finite number."},
      {"VERTEX_SE2 2 nan 0 0", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0 inf 0", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0 1e999 0", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0 0 zero", "a field is missing or not a finite number"},
      {"VERTEX_SE2 2 0 0 0 9", "bad.g2o:3: VERTEX_SE2: there is more than expected: '9'."},
      {"EDGE_SE2 0 7 0 0 0 1 0 0 1 0 1", "bad.g2o:3: node 7 is not in the file."},
      {"EDGE_SE2 8 1 0 0 0 1 0 0 1 0 1", "bad.g2o:3: node 8 is not in the file."},
      {"EDGE_SE2 1 1 0 0 0 1 0 0 1 0 1", "EDGE_SE2: node 1 is tied to itself."},
      {"EDGE_SE2 0 1 0 0 0 1 0 0 1 0", "a field is missing or not a finite number"},
      {"EDGE_SE2 0 1 0 0 0 1 0 0 nan 0 1", "a field is missing or not a finite number"},
      {"EDGE_SE2 0 1 0 0 0 -1 0 0 1 0 1", "the information matrix is not positive semi-definite"},
      {"EDGE_SE2 0 1 0 0 0 1 5 0 1 0 1", "the information matrix is not positive semi-definite"},
      {"FIX 9", "bad.g2o:3: node 9 is not in the file."},
      {"FIX", "FIX: an id is missing"},
      {"FIX 0 x", "FIX: an id is missing"},
      {"VERTEX_XY 2 0", "VERTEX_XY: a field is missing"},
      {"VERTEX_XY 1 0 0", "node 1 was there before"},
      {"VERTEX2 1 0 0 0", "node 1 was there before"},
      {"EDGE2 0 1 0 0 0 1 0 1 1 0 9", "the information matrix is not positive semi-definite"},
      {"EDGE_SE2_XY 0 1 0 0 1 0 1", "bad.g2o:3: node 1 is a pose, and was to be a point."},
      {"VERTEX_XY 2 0 0\nEDGE_SE2 0 2 0 0 0 1 0 0 1 0 1",
       "bad.g2o:4: a point can only be the second node of an EDGE_SE2_XY."},
      {"VERTEX_XY 2 0 0\nEDGE_SE2_XY 2 0 0 0 1 0 1",
       "bad.g2o:4: a point can only be the second node of an EDGE_SE2_XY."},
      {"EDGE_SE2_XY 0 1 0 0 1 5 1", "the information matrix is not positive semi-definite"},
      {"VERTEX_SE3:QUAT 2 0 0 0 0 0 0 1", "VERTEX_SE3:QUAT: this tag is unknown here"},
      {"vertex_se2 2 0 0 0", "vertex_se2: this tag is unknown here"},
  };
  for (const Row& row : rows) {
    EXPECT_THAT(complaint(two + row.line + "\n"), HasSubstr(row.says)) << row.line;
  }
}

TEST(GraphFileHostile, SemiDefiniteInformationIsGood) {
  EXPECT_EQ(complaint("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 0 0 0 0 0 0 0 0 0\n"
                      "EDGE_SE2 0 1 0 0 0 1 1 0 1 0 0\n"),
            "");
}

TEST(GraphFileHostile, AbsurdIdsDoNotFillTheMemory) {
  EXPECT_EQ(complaint("EDGE_SE2 0 4294967295 0 0 0 1 0 0 1 0 1\n"), "");
}

TEST(GraphFileHostile, FilesThatCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(loadGraph(folder.path() / "absent.g2o")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(loadGraph(folder.path())), std::runtime_error);
}

TEST(GraphFileHostile, PartsWithoutATieAreReadAsTheyAre) {
  const std::string text =
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 7 0 0\nFIX 0\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";
  EXPECT_EQ(toG2o(readGraph(text, "parts.g2o")), text);
}

TEST(GraphFileHostile, EdgesAloneThatLeadBeyondAllNumbers) {
  EXPECT_THAT(complaint("EDGE_SE2 0 1 1e308 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1e308 0 0 1 0 0 1 0 1\n"),
              HasSubstr("bad.g2o: the edges that lead to node 2 are too long."));
}

TEST(GraphFileHostile, ComplaintsAboutABinaryFileAreShortAndPrintable) {
  const std::string said = complaint("FIX\x1b[2J\x01" + std::string(100000, '\xff'));
  EXPECT_LT(said.size(), 200U);
  EXPECT_THAT(said, HasSubstr("bad.g2o:1: FIX?[2J??"));
}

TEST(GraphFileHostile, TextsThatOnceBrokeALawKeepItNow) {
  for (const char* text : {
           "VERTEX_SE2 0 0 0 1e16\n",
           "EDGE_SE2 0 1 0 0 1e18 1 0 0 1 0 1\n",
           "EDGE_SE2 0 1 0 0 1 1 0 0 1 0 1\nEDGE_SE2_XY 1 7 2 3 1 0 1\n",
           "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 1\nEDGE_SE2_XY 0 1 2 3 1 0 1\n",
       }) {
    EXPECT_EQ(test::brokenLawOfReading(text), "") << text;
  }
}

TEST(GraphFileHostile, SeedsOfTheFuzzerKeepTheLaws) {
  int seeds = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(test::sourceFolder() / "test/fuzz/corpus")) {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_EQ(test::brokenLawOfReading(text), "") << file.path();
    ++seeds;
  }
  EXPECT_GT(seeds, 0);
}

TEST(GraphFileHostile, DamagedTextNeverDoesWorseThanAnError) {
  const std::string good =
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_XY 2 1 0\nFIX 0\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2_XY 0 2 1 0 1 0 1\n";
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 1000; ++trial) {
      std::string text = good;
      for (int change = 0; change < 3; ++change) {
        text[random() % text.size()] = static_cast<char>(random() % 256);
      }
      ASSERT_EQ(test::brokenLawOfReading(text), "") << text;
    }
  }
}

}  // namespace
}  // namespace omega_slam::graph
