#include "omega_slam/matching/tiled_grid.h"

#include <gtest/gtest.h>

#include <limits>

namespace omega_slam::matching {
namespace {

TEST(TiledGridTest, CellsNeverWrittenAreEmpty) {
  TiledGrid<int> grid({-5, -5}, {5, 5});
  grid(0, 0) = 7;
  EXPECT_EQ(grid.at(0, 0), 7);
  EXPECT_EQ(grid.at(1, 0), 0) << "in the same tile";
  EXPECT_EQ(TiledGrid<int>().at(0, 0), 0);
}

TEST(TiledGridTest, CellsOutsideAreEmpty) {
  TiledGrid<int> grid({-40, -40}, {40, 40});
  for (int y = -40; y <= 40; ++y) {
    for (int x = -40; x <= 40; ++x) {
      grid(x, y) = 1;
    }
  }
  constexpr int kLast = std::numeric_limits<int>::max();
  EXPECT_EQ(grid.at(-41, 0), 0);
  EXPECT_EQ(grid.at(0, -41), 0);
  EXPECT_EQ(grid.at(56, 0), 0) << "beyond the last tile";
  EXPECT_EQ(grid.at(kLast, -kLast), 0);
}

TEST(TiledGridTest, EveryCellHasAPlaceOfItsOwn) {
  TiledGrid<int> grid({-33, 31}, {40, 97});
  const auto number = [](int x, int y) { return 1000 * y + x + 100; };
  for (int y = 31; y <= 97; ++y) {
    for (int x = -33; x <= 40; ++x) {
      grid(x, y) = number(x, y);
    }
  }
  for (int y = 31; y <= 97; ++y) {
    for (int x = -33; x <= 40; ++x) {
      ASSERT_EQ(grid.at(x, y), number(x, y));
    }
  }
}

TEST(TiledGridTest, RowIsVisitedOnceFromEndToEnd) {
  TiledGrid<int> grid({-50, 0}, {50, 3});
  grid.visitRow(-45, 40, 2, [](int first, int* cells, int count) {
    for (int i = 0; i < count; ++i) {
      cells[i] += 1000 + first + i;
    }
  });
  for (int x = -50; x <= 50; ++x) {
    EXPECT_EQ(grid.at(x, 2), x >= -45 && x <= 40 ? 1000 + x : 0) << x;
    EXPECT_EQ(grid.at(x, 1), 0);
  }
}

TEST(TiledGridTest, FourAtOnceAreWhatEachIs) {
  TiledGrid<int> grid({-33, -10}, {64, 40});
  for (int x = -33; x <= 64; ++x) {
    grid(x, x % 7 + 20) = x + 100;
    grid(x, x % 5 - 2) = x + 500;
  }
  for (const int step : {1, 2, 31}) {
    for (int y = -80; y <= 80; ++y) {
      for (int x = -80; x <= 120; ++x) {
        const std::array<int, 4> each{grid.at(x, y), grid.at(x + step, y), grid.at(x, y + step),
                                      grid.at(x + step, y + step)};
        ASSERT_EQ(grid.atFour(x, y, step), each) << x << ", " << y << " step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace omega_slam::matching
