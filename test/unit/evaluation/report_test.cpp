#include "omega_slam/evaluation/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "omega_slam/grid/atomic_file.h"
#include "support/temporary_folder.h"

namespace omega_slam::evaluation {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

Report fullReport() {
  Report report;
  report.input = "lab";
  report.duration = 120.5;
  report.distance = 33.25;
  report.scans = ScanFigures{100, {{"range_min below 0", 7}}, {{"no beams", 2}, {"stamp", 1}}};
  report.keyframes = 42;
  report.loops =
      std::vector<LoopFigures>{{40, 1, 0.05, 0.01, 2.5, 0.9}, {41, 2, 0.5, 0.1, 9, 0.8, 0.25}};
  report.chi_square = 12.5;
  report.map = grid::GridGeometry{0.05, {-1, -2}, 200, 100};
  report.trajectory_error = TrajectoryError{90, 10, {1, 2, 3}, summarize({0.03, 0.05}), {}};
  report.relations = RelationsScore{10, 8, summarize({0.1, 0.3}), summarize({0.01})};
  report.resemblance = Resemblance{};
  report.resemblance->walls_right = 3;
  report.resemblance->walls_wrong = 1;
  report.notes = {"Ended early."};
  return report;
}

TEST(Report, JsonHoldsTheFigures) {
  const Json json = Json::parse(toJson(fullReport()));
  EXPECT_EQ(json["input"], "lab");
  EXPECT_EQ(json["duration"], 120.5);
  EXPECT_EQ(json["scans"]["used"], 100);
  EXPECT_EQ(json["scans"]["rejected"], 3);
  EXPECT_EQ(json["scans"]["rejections"]["no beams"], 2);
  EXPECT_EQ(json["scans"]["repairs"]["range_min below 0"], 7);
  EXPECT_EQ(json["loops"].size(), 2U);
  EXPECT_EQ(json["loops"][1]["residual_translation"], 0.5);
  EXPECT_FALSE(json["loops"][0].contains("weight"));
  EXPECT_EQ(json["loops"][1]["weight"], 0.25);
  EXPECT_EQ(json["map"]["origin"], Json({-1.0, -2.0}));
  EXPECT_NEAR(json["absolute_trajectory_error"]["translation"]["mean"].get<double>(), 0.04, 1e-12);
  EXPECT_EQ(json["relations"]["covered"], 8);
  EXPECT_EQ(json["resemblance"]["score"], 0.75);
  EXPECT_EQ(json["notes"][0], "Ended early.");
}

TEST(Report, WhatIsNotKnownIsLeftOut) {
  Report report;
  report.input = "log";
  const Json json = Json::parse(toJson(report));
  EXPECT_EQ(json.size(), 2U);  // input and format
  EXPECT_EQ(toMarkdown(report), "# Report: log\n\n");
}

TEST(Report, MarkdownSaysItForPeople) {
  const std::string page = toMarkdown(fullReport());
  EXPECT_THAT(page, HasSubstr("| absolute trajectory error | mean 0.0400 m, rms 0.0412 m"));
  EXPECT_THAT(page, HasSubstr("| resemblance | 75.00 % |"));
  EXPECT_THAT(page, HasSubstr("| relations covered | 8 of 10 |"));
  EXPECT_THAT(page, HasSubstr("| no beams | 2 |"));
  // The worst loop comes first.
  EXPECT_LT(page.find("| 41 | 2 | 0.500 m |"), page.find("| 40 | 1 | 0.050 m |"));
  EXPECT_THAT(page, HasSubstr("* Ended early.\n"));
}

TEST(Report, NumbersThatAreNoneAndOddBytesDoNotBreakIt) {
  Report report = fullReport();
  report.chi_square = std::nan("");
  report.input = "caf\xe9";
  EXPECT_TRUE(Json::parse(toJson(report))["chi_square"].is_null());
}

TEST(Report, TimesAreSummarised) {
  std::vector<double> seconds;
  for (int k = 200; k >= 1; --k) {
    seconds.push_back(k * 0.001);
  }
  const TimingFigures timing = summarizeTimes("scan", seconds);
  EXPECT_EQ(timing.count, 200U);
  EXPECT_NEAR(timing.median, 0.100, 1e-12);
  EXPECT_NEAR(timing.percentile_99, 0.198, 1e-12);
  EXPECT_NEAR(timing.max, 0.200, 1e-12);
  EXPECT_NEAR(timing.total, 20.1, 1e-9);
  EXPECT_EQ(summarizeTimes("none", {}).max, 0.0);
  EXPECT_EQ(Json::parse(toJson({timing}))["timings"]["scan"]["count"], 200);
}

TEST(Report, FilesAreWrittenAndTheSameForTheSameRun) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(writeReport(folder.path() / "a", fullReport(), {summarizeTimes("x", {1})}), "");
  ASSERT_EQ(writeReport(folder.path() / "b", fullReport(), {summarizeTimes("x", {2})}), "");
  for (const char* name : {"report.json", "report.md"}) {
    EXPECT_EQ(grid::readFile(folder.path() / "a" / name),
              grid::readFile(folder.path() / "b" / name));
  }
  EXPECT_THAT(grid::readFile(folder.path() / "a" / "report.json"), Not(HasSubstr("median")));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a" / "timing.json"));
}

TEST(Report, EveryFileThatFailsIsNamed) {
  const test::TemporaryFolder folder;
  folder.write("file", "");
  const std::string fault = writeReport(folder.path() / "file", fullReport(), {});
  for (const char* name : {"report.json", "report.md", "timing.json"}) {
    EXPECT_THAT(fault, HasSubstr(std::string(name) + " could not be written"));
  }
}

TEST(LoopFigures, ResidualsAreInTheFrameOfTheMeasurement) {
  graph::PoseGraph graph;
  graph.poses = {{0, 0, 0}, {3.0, 4.0, 0.2}};
  graph::Constraint loop;
  loop.to = 1;
  loop.kind = graph::ConstraintKind::kLoop;
  loop.information = Eigen::Vector3d(1.0, 2.0, 10.0).asDiagonal();
  loop.confidence = 0.7;
  graph.constraints = {loop, loop};
  graph.constraints[0].kind = graph::ConstraintKind::kMatch;
  const std::vector<LoopFigures> figures = loopFigures(graph);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_NEAR(figures[0].residual_translation, 5.0, 1e-12);
  EXPECT_NEAR(figures[0].residual_rotation, 0.2, 1e-12);
  EXPECT_NEAR(figures[0].chi_square, 9.0 + 32.0 + 0.4, 1e-12);
}

TEST(LoopFigures, WeightsAreThoseOfTheLoopsAndNoneOfWithdrawnOnes) {
  graph::PoseGraph graph;
  graph.poses.resize(2);
  graph::Constraint loop;
  loop.to = 1;
  loop.kind = graph::ConstraintKind::kLoop;
  graph.constraints = {loop, loop};
  graph.constraints[0].kind = graph::ConstraintKind::kMatch;
  EXPECT_EQ(loopFigures(graph, {0.5, 0.25})[0].weight, 0.25);
  EXPECT_FALSE(loopFigures(graph)[0].weight);
  loop.T_from_to.x = 3.0;
  const std::vector<LoopFigures> figures = loopFigures(graph, {0.5, 0.25}, {loop});
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[1].weight, 0.0);
  EXPECT_EQ(figures[1].residual_translation, 3.0);
}

TEST(LoopFigures, FoldedLoopsAreListedAsSuch) {
  graph::PoseGraph graph;
  graph.poses.resize(2);
  graph::Constraint loop;
  loop.to = 1;
  loop.T_from_to.x = 3.0;
  loop.kind = graph::ConstraintKind::kLoop;
  Report report;
  report.loops = loopFigures(graph, {}, {loop}, {loop});
  ASSERT_EQ(report.loops->size(), 2U);
  EXPECT_FALSE(report.loops->front().is_folded);
  EXPECT_TRUE(report.loops->back().is_folded);
  EXPECT_EQ(report.loops->back().residual_translation, 3.0);
  EXPECT_NE(toJson(report).find("\"folded\": true"), std::string::npos);
  EXPECT_NE(toMarkdown(report).find("| folded |"), std::string::npos);
}

TEST(PathLength, SumsTheSteps) {
  EXPECT_EQ(pathLength({}), 0.0);
  EXPECT_DOUBLE_EQ(pathLength({{0, {0, 0, 0}}, {1, {3, 4, 1}}, {2, {3, 5, 2}}}), 6.0);
}

}  // namespace
}  // namespace omega_slam::evaluation
