#include "omega_slam/mapping/sweep_renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace omega_slam::mapping {
namespace {

using sensing::BeamKind;

/// A sweep from the middle of cell (0, 0), of cells of 1 m, to the middles of others.
sensing::Sweep sweepTo(const std::vector<sensing::Beam>& beams, double angle_increment) {
  sensing::Sweep sweep;
  sweep.angle_increment = angle_increment;
  sweep.beams = beams;
  return sweep;
}

sensing::Beam hitAt(double x, double y) { return {{x, y}, BeamKind::kReturn}; }
sensing::Beam openTo(double x, double y) { return {{x, y}, BeamKind::kNoReturn}; }
sensing::Beam nothing() { return {{0.0, 0.0}, BeamKind::kUnknown}; }

RendererConfig triangleConfig(bool join_all = false, double max_range_gap = 0.3) {
  RendererConfig config;
  config.kind = RendererKind::kTriangle;
  config.triangle = {join_all, max_range_gap};
  return config;
}

/// The rows of a rectangle, top row first: '#' occupied, '.' free, ' ' nothing said.
std::vector<std::string> drawn(const RendererConfig& config, const sensing::Sweep& sweep,
                               const CellBox& box) {
  SweepRays rays;
  EXPECT_EQ(placeRays(sweep, {0.5, 0.5, 0.0}, 1.0, 0.0, rays), "");
  SweepCells cells;
  makeRenderer(config)->render(rays, cells);
  std::vector<std::string> rows;
  for (int y = box.max().y(); y >= box.min().y(); --y) {
    std::string row;
    for (int x = box.min().x(); x <= box.max().x(); ++x) {
      const SweepTile* tile = cells.find(tileOf({x, y}));
      const grid::Cell place = withinTile({x, y});
      const auto isIn = [&place](const TileBits& bits) {
        return (bits[static_cast<std::size_t>(place.y())] >> static_cast<unsigned>(place.x()) &
                1U) != 0;
      };
      row += tile != nullptr && isIn(tile->occupied) ? '#'
             : tile != nullptr && isIn(tile->free)   ? '.'
                                                     : ' ';
    }
    rows.push_back(row);
  }
  return rows;
}

using Rows = std::vector<std::string>;
const CellBox kBox(grid::Cell(0, -3), grid::Cell(6, 3));

TEST(BeamRenderer, DrawsEachBeamByItself) {
  EXPECT_EQ(drawn({}, sweepTo({hitAt(5, -2), openTo(4, 0), hitAt(3, 3)}, 0.5), kBox),
            (Rows{"   #   ",  //
                  "  .    ",  //
                  " .     ",  //
                  ".....  ",  //
                  " ....  ",  //
                  "    .# ",  //
                  "       "}));
}

TEST(BeamRenderer, NoiseLeavesCellsBeforeAHitAlone) {
  RendererConfig config;
  config.range_noise = 0.8;
  EXPECT_EQ(drawn(config, sweepTo({hitAt(5, 0)}, 0.5), kBox)[3], ".... # ");
  EXPECT_EQ(drawn(config, sweepTo({hitAt(1, 0)}, 0.5), kBox)[3], ".#     ");
  EXPECT_EQ(drawn(config, sweepTo({openTo(5, 0)}, 0.5), kBox)[3], "...... ");
}

TEST(BeamRenderer, AWideBeamCoversWhatItsWidthReaches) {
  RendererConfig config;
  config.beam_width = 0.5;  // at 5 cells 2.5 cells wide
  EXPECT_EQ(drawn(config, sweepTo({hitAt(5, 0)}, 0.5), kBox),
            (Rows{"       ",  //
                  "       ",  //
                  "    .# ",  //
                  ".....# ",  //
                  "    .# ",  //
                  "       ",  //
                  "       "}));
}

/// A wall at x = 5, seen by three beams.
const std::vector<sensing::Beam> kWall{hitAt(5, -3), hitAt(5, 0), hitAt(5, 3)};
constexpr double kWallIncrement = 0.54;

TEST(TriangleRenderer, FillsBetweenBeamsAndJoinsTheirEnds) {
  EXPECT_EQ(drawn(triangleConfig(false, 1.0), sweepTo(kWall, kWallIncrement), kBox),
            (Rows{"    .# ",  //
                  "   ..# ",  //
                  " ....# ",  //
                  ".....# ",  //
                  " ....# ",  //
                  "   ..# ",  //
                  "    .# "}));
}

TEST(TriangleRenderer, AnOpenDoorStaysOpen) {
  // The middle beam goes through a door to a wall behind.
  const auto sweep = sweepTo({hitAt(3, -2), hitAt(6, 0), hitAt(3, 2)}, 0.6);
  const Rows open = drawn(triangleConfig(), sweep, kBox);
  EXPECT_EQ(open[3], "......#");
  EXPECT_EQ(open[1], "  .#   ");
  EXPECT_EQ(open[2], " ...   ") << "free up to the nearer of both ranges";
  const Rows plain = drawn(triangleConfig(true), sweep, kBox);
  EXPECT_EQ(plain[2], "  ..## ") << "the paper's rule draws a wall to what is behind";
}

TEST(TriangleRenderer, NothingJoinsBeamsWithoutAHit) {
  const auto sweep = sweepTo({hitAt(5, -3), openTo(5, 0), openTo(5, 3)}, kWallIncrement);
  EXPECT_EQ(drawn(triangleConfig(false, 9.0), sweep, kBox),
            (Rows{"    .. ",  //
                  "   ... ",  //
                  " ..... ",  //
                  "...... ",  //
                  " ..... ",  //
                  "   ... ",  //
                  "    .# "}));
  EXPECT_EQ(drawn(triangleConfig(true), sweep, kBox),
            (Rows{"     . ",  //
                  "    .. ",  //
                  "  .... ",  //
                  "...... ",  //
                  "  .... ",  //
                  "    .. ",  //
                  "     # "}));
}

TEST(TriangleRenderer, BeamsThatSayNothingLeaveAGap) {
  EXPECT_EQ(drawn(triangleConfig(false, 9.0),
                  sweepTo({hitAt(5, -3), nothing(), hitAt(5, 3)}, kWallIncrement), kBox),
            drawn({}, sweepTo({hitAt(5, -3), hitAt(5, 3)}, kWallIncrement), kBox));
}

TEST(TriangleRenderer, SoDoesTooWideAnAngle) {
  EXPECT_EQ(drawn(triangleConfig(false, 9.0), sweepTo(kWall, 0.3), kBox),
            drawn({}, sweepTo(kWall, 0.3), kBox));
}

TEST(SweepRenderer, TheSameSweepGivesTheSameCellsHoweverOftenMemoryWasUsed) {
  SweepRays rays;
  ASSERT_EQ(placeRays(sweepTo(kWall, kWallIncrement), {0.5, 0.5, 0.0}, 1.0, 0.0, rays), "");
  const auto renderer = makeRenderer(triangleConfig());
  SweepCells cells;
  renderer->render(rays, cells);
  const std::vector<SweepTile> first = cells.tiles();
  renderer->render(rays, cells);
  ASSERT_EQ(cells.tiles().size(), first.size());
  EXPECT_EQ(cells.tiles()[0].free, first[0].free);
  EXPECT_EQ(cells.tiles()[0].occupied, first[0].occupied);
}

TEST(RendererConfig, NamesEveryFault) {
  EXPECT_TRUE(RendererConfig().validate().empty());
  RendererConfig config;
  config.beam_width = std::nan("");
  config.range_noise = -1.0;
  config.triangle.max_range_gap = -1.0;
  EXPECT_EQ(config.validate().size(), 3U);
  EXPECT_THROW(static_cast<void>(makeRenderer(config)), std::invalid_argument);
}

}  // namespace
}  // namespace omega_slam::mapping
