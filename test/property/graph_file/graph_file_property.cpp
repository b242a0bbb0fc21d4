#include <gtest/gtest.h>

#include <random>

#include "omega_slam/graph/graph_file.h"
#include "support/seeds.h"

namespace omega_slam::graph {
namespace {

PoseGraph randomGraph(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1e6, 1e6);
  std::uniform_real_distribution<double> angle(-3.14, 3.14);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<NodeId> node(0, 29);
  PoseGraph graph;
  for (int k = 0; k < 30; ++k) {
    graph.poses.push_back({place(random), place(random), angle(random)});
  }
  for (int k = 0; k < 100; ++k) {
    Constraint constraint;
    constraint.from = node(random);
    constraint.to = (constraint.from + 1 + node(random) % 29) % 30;
    constraint.T_from_to = {place(random), place(random), angle(random)};
    const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return normal(random); });
    constraint.information = root * root.transpose();
    // Not every rounding of the product is symmetric to the last bit; an information matrix is.
    constraint.information =
        constraint.information.selfadjointView<Eigen::Upper>().toDenseMatrix().eval();
    graph.constraints.push_back(constraint);
  }
  return graph;
}

TEST(GraphFileProperty, WritingAndReadingGivesTheSameBits) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PoseGraph graph = randomGraph(random);
    const std::string text = toG2o(graph);
    const PoseGraph again = readGraph(text, "g").graph;
    ASSERT_EQ(again.poses.size(), graph.poses.size());
    ASSERT_EQ(again.constraints.size(), graph.constraints.size());
    for (std::size_t k = 0; k < graph.poses.size(); ++k) {
      EXPECT_EQ(again.poses[k].vector().head<2>(), graph.poses[k].vector().head<2>());
      // Headings pass through the wrap into [-pi, pi), which may cost the last digit.
      EXPECT_NEAR(again.poses[k].theta, graph.poses[k].theta, 1e-15);
    }
    for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
      EXPECT_EQ(again.constraints[k].from, graph.constraints[k].from);
      EXPECT_EQ(again.constraints[k].to, graph.constraints[k].to);
      EXPECT_EQ(again.constraints[k].information, graph.constraints[k].information);
    }
  }
}

}  // namespace
}  // namespace omega_slam::graph
