#include "exploration/watchman_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "exploration/held_karp.h"

namespace omega_slam::experiments {
namespace {

/// The shortest closed tour, by looking at all.
double shortestTour(const Eigen::MatrixXd& distances) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(distances.rows()));
  std::iota(order.begin(), order.end(), 0);
  double least = 1e9;
  do {
    double length = distances(order.back(), order.front());
    for (std::size_t i = 1; i < order.size(); ++i) {
      length += distances(order[i - 1], order[i]);
    }
    least = std::min(least, length);
  } while (std::next_permutation(order.begin() + 1, order.end()));
  return least;
}

TEST(TourBound, IsNeverAboveTheShortestTourAndCloseToIt) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(0.0, 10.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix2Xd places =
        Eigen::Matrix2Xd::NullaryExpr(2, 7, [&] { return place(random); });
    Eigen::MatrixXd distances(7, 7);
    for (int i = 0; i < 7; ++i) {
      for (int k = 0; k < 7; ++k) {
        distances(i, k) = (places.col(i) - places.col(k)).norm();
      }
    }
    const double shortest = shortestTour(distances);
    EXPECT_LE(tourBound(distances), shortest + 1e-9);
    EXPECT_GE(tourBound(distances), 0.93 * shortest);
  }
}

TEST(TourBound, OfFewPlacesIsThereAndBack) {
  EXPECT_EQ(tourBound(Eigen::MatrixXd::Zero(1, 1)), 0.0);
  Eigen::MatrixXd two(2, 2);
  two << 0.0, 3.0, 3.0, 0.0;
  EXPECT_EQ(tourBound(two), 6.0);
}

simulation::World corridor(double length) {
  grid::GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = static_cast<int>(std::lround(length / geometry.resolution)) + 2;
  geometry.height = 12;
  std::vector<simulation::Material> cells(geometry.size(), simulation::Material::kNone);
  for (int row = 0; row < geometry.height; ++row) {
    for (int column = 0; column < geometry.width; ++column) {
      if (row == 0 || column == 0 || row + 1 == geometry.height || column + 1 == geometry.width) {
        cells[geometry.index({column, row})] = simulation::Material::kWall;
      }
    }
  }
  return {geometry, std::move(cells)};
}

TEST(WatchmanBound, OfACorridorIsTheWayBetweenWhereBothEndsComeIntoSight) {
  const WatchmanBound bound = watchmanBound(corridor(20.0), {5.0, 0.6}, 0.2, 4.0);
  const double truth = 2.0 * (20.0 - 2.0 * 4.0);
  EXPECT_LE(bound.length, truth);
  EXPECT_GE(bound.length, 0.85 * truth);
  EXPECT_EQ(bound.witnesses.size(), 2U);
}

TEST(WatchmanBound, IsNothingWhereAllIsInSight) {
  EXPECT_EQ(watchmanBound(corridor(3.0), {1.0, 0.6}, 0.2, 4.0).length, 0.0);
}

}  // namespace
}  // namespace omega_slam::experiments
