#include "support/drawn_map.h"

namespace omega_slam::test {

grid::OccupancyGrid drawnMap(const std::vector<std::string>& rows, double resolution, int cells) {
  const int height = static_cast<int>(rows.size()) * cells;
  const int width = static_cast<int>(rows.front().size()) * cells;
  grid::OccupancyGrid map = grid::makeGrid({resolution, {0.0, 0.0}, width, height}, grid::kFree);
  for (int row = 0; row < height; ++row) {
    const std::string& line = rows[static_cast<std::size_t>((height - 1 - row) / cells)];
    for (int column = 0; column < width; ++column) {
      const char mark = line[static_cast<std::size_t>(column / cells)];
      if (mark == '#') {
        map.at({column, row}) = grid::kOccupied;
      } else if (mark == '?') {
        map.at({column, row}) = grid::kUnknown;
      }
    }
  }
  return map;
}

}  // namespace omega_slam::test
