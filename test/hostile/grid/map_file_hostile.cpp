#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/grid/map_file.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// What loading says; empty if it works.
std::string complaint(const fs::path& yaml) {
  try {
    static_cast<void>(loadMapImage(yaml));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const char* const kGoodYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

TEST(MapFileHostile, MissingYamlAndMissingImage) {
  const test::TemporaryFolder folder;
  const fs::path absent = folder.path() / "absent.yaml";
  EXPECT_EQ(complaint(absent), absent.string() + " could not be read: No such file or directory.");
  EXPECT_EQ(complaint(folder.write("m.yaml", kGoodYaml)),
            (folder.path() / "m.pgm").string() + " could not be read: No such file or directory.");
  EXPECT_THAT(complaint(folder.path()), HasSubstr("Is a directory"));
}

TEST(MapFileHostile, YamlFaultsNameTheKey) {
  const test::TemporaryFolder folder;
  folder.write("m.pgm", "P2 1 1 255 0");
  struct Row {
    const char* from;
    const char* to;
    const char* says;
  };
  const Row rows[] = {
      {"image: m.pgm\n", "", "key 'image' is missing"},
      {"image: m.pgm", "image: ''", "key 'image' names no file"},
      {"image: m.pgm", "image: [1]", "key 'image' must be a file name"},
      {"0.05", "fine", "key 'resolution' must be a number of metres"},
      {"0.05", "0", "key 'resolution' must be above 0 m, not 0"},
      {"0.05", "-0.05", "key 'resolution' must be above 0 m"},
      {"0.05", ".nan", "key 'resolution' must be above 0 m"},
      {"resolution: 0.05\n", "", "key 'resolution' is missing"},
      {"resolution", "resolutoin", "key 'resolutoin' is not known; there are image, resolution,"},
      {"negate: 0", "negate: 0\nMode: raw", "key 'Mode' is not known"},
      {"negate: 0", "negate: 0\n[1]: 2", "key '' is not known"},
      {"0.65", "0.196", "0 <= free_thresh < occupied_thresh <= 1, not 0.196 and 0.196"},
      {"[0, 0, 0]", "[0, 0]", "key 'origin' must be three finite numbers [x, y, yaw]"},
      {"[0, 0, 0]", "[0, .inf, 0]", "key 'origin' must be three finite numbers [x, y, yaw]"},
      {"[0, 0, 0]", "here", "key 'origin' must be three numbers [x, y, yaw]"},
      {"[0, 0, 0]", "[0, 0, 0.5]", "key 'origin' has a yaw of 0.5; only 0 is supported"},
      {"negate: 0", "negate: 2", "key 'negate' must be 0 or 1"},
      {"negate: 0\n", "", "key 'negate' is missing"},
      {"0.65", "0.1", "0 <= free_thresh < occupied_thresh <= 1, not 0.196 and 0.1"},
      {"0.65", ".nan", "0 <= free_thresh < occupied_thresh <= 1"},
      {"0.65", "1.5", "0 <= free_thresh < occupied_thresh <= 1"},
      {"0.196", "-1", "0 <= free_thresh < occupied_thresh <= 1"},
      {"negate: 0", "negate: 0\nmode: quad",
       "key 'mode' must be trinary, scale or raw, not 'quad'"},
  };
  for (const Row& row : rows) {
    const fs::path yaml = folder.write("m.yaml", replaced(kGoodYaml, row.from, row.to));
    const std::string said = complaint(yaml);
    EXPECT_THAT(said, HasSubstr(row.says)) << row.to;
    EXPECT_THAT(said, ::testing::StartsWith(yaml.string() + ": ")) << row.to;
    EXPECT_EQ(said.back(), '.') << row.to;
  }
}

TEST(MapFileHostile, YamlThatIsNone) {
  const test::TemporaryFolder folder;
  for (const char* text : {"", "just words", "[1, 2]", "42"}) {
    EXPECT_THAT(complaint(folder.write("m.yaml", text)), HasSubstr("it has no keys")) << text;
  }
  EXPECT_THAT(complaint(folder.write("m.yaml", "image: [unclosed\n")), HasSubstr("not YAML"));
  EXPECT_NE(complaint(folder.write("m.yaml", std::string("\x00\xff\x01", 3))), "");
}

TEST(MapFileHostile, ImageFaultsNameTheImage) {
  const test::TemporaryFolder folder;
  const fs::path yaml = folder.write("m.yaml", kGoodYaml);
  const std::pair<std::string, const char*> rows[] = {
      {"", "it is no image, or a damaged one"},
      {"\x89PNG\r\n", "it is no image, or a damaged one"},
      {"P5", "the width is missing or not a number"},
      {"P5 ten 1 255\n", "the width is missing or not a number"},
      {"P5 -1 1 255\n", "the width is missing or not a number"},
      {"P5 2 # only a comment", "the height is missing or not a number"},
      {"P5 2 2 255\nabc", "the image is cut off: its header promises at least 5 bytes"},
      {"P5 2 2 65535\nabcdefg", "the image is cut off"},
      {"P5 2 2 255\nabcdef", "after the pixels that its header promises 2 bytes are left"},
      {"P2 2 1 255\n0 0 0", "after the pixels that its header promises 2 bytes are left"},
      {"P2 2 2 255\n0 0 0", "the image is cut off"},
      {"P2 2 2 255\n0 0 x 0      ", "a pixel is missing or not a number"},
      {"P2 2 1 255\n0 256", "a pixel of 256 is above the maximum 255"},
      {"P5 0 5 255\n", "a size of 0 x 5 pixels is not usable"},
      {"P5 1000000 1000000 255\n", "a size of 1000000 x 1000000 pixels is not usable"},
      {"P5 99999999999999999999 1 255\n", "the width is absurdly large"},
      {"P5 16000 16000 255\nabc", "the image is cut off"},
      {"P5 1 1 0\n0", "a maximum grey value of 0 is not allowed"},
      {"P5 1 1 70000\n0", "a maximum grey value of 70000 is not allowed"},
  };
  for (const auto& [bytes, says] : rows) {
    const fs::path image = folder.write("m.pgm", bytes);
    const std::string said = complaint(yaml);
    EXPECT_THAT(said, HasSubstr(says)) << bytes;
    EXPECT_THAT(said, ::testing::StartsWith(image.string() + ": ")) << bytes;
  }
}

/// A PNG as saveMap writes it.
std::string goodPng(const test::TemporaryFolder& folder) {
  const OccupancyGrid map = makeGrid({0.05, {0, 0}, 40, 30}, kUnknown);
  return readFile(
      saveMap(map, folder.path() / "good", {MapMode::kScale, ImageKind::kPng}).paths.at(0));
}

TEST(MapFileHostile, PngFaultsNameTheImage) {
  const test::TemporaryFolder folder;
  const fs::path yaml = folder.write("m.yaml", replaced(kGoodYaml, "m.pgm", "m.png"));
  const std::string good = goodPng(folder);
  std::string huge = good;
  huge.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));  // 30000 x 30000
  const std::pair<std::string, const char*> rows[] = {
      {good.substr(0, 8), "the image is cut off"},
      {good.substr(0, 30), "the image is cut off"},
      {good.substr(0, good.size() / 2), "the image is cut off"},
      {good.substr(0, good.size() - 12), "the image is cut off"},
      {good.substr(0, good.size() - 1), "the image is cut off"},
      {huge, "a size of 30000 x 30000 pixels is not usable"},
      {replaced(good, std::string("\0\0\0\x28", 4), std::string(4, '\0')), "a size of 0 x 30"},
      {"GIF89a", "it is no image, or a damaged one"},
  };
  for (const auto& [bytes, says] : rows) {
    const fs::path image = folder.write("m.png", bytes);
    const std::string said = complaint(yaml);
    EXPECT_THAT(said, HasSubstr(says)) << bytes.size();
    EXPECT_THAT(said, ::testing::StartsWith(image.string() + ": "));
  }
  folder.write("m.png", good);
  EXPECT_EQ(complaint(yaml), "");
}

/// Cuts and changes a good image in many ways; each must be read whole or refused by its name.
void damage(const std::string& good, const std::string& name) {
  const test::TemporaryFolder folder;
  const fs::path yaml = folder.write("m.yaml", replaced(kGoodYaml, "m.pgm", name));
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 300; ++trial) {
      std::string bytes = good.substr(0, random() % 2 == 0 ? good.size() : random() % good.size());
      for (int change = 0; change < 3 && !bytes.empty(); ++change) {
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      }
      folder.write(name, bytes);
      try {
        const MapImage image = loadMapImage(yaml);
        ASSERT_EQ(image.pixels.size(), image.geometry.size());
        ASSERT_EQ(toOccupancyGrid(image).cells.size(), image.geometry.size());
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), HasSubstr(name));
      }
    }
  }
}

TEST(MapFileHostile, ADamagedPgmDoesNoWorseThanAnError) {
  damage("P5\n# comment\n4 3\n255\n" + std::string(12, '\x7f'), "m.pgm");
}

TEST(MapFileHostile, ADamagedPngDoesNoWorseThanAnError) {
  damage(goodPng(test::TemporaryFolder()), "m.png");
}

TEST(MapFileHostile, MapsThatCannotBeSavedAreRefused) {
  const test::TemporaryFolder folder;
  const fs::path stem = folder.path() / "map";
  EXPECT_EQ(saveMap({}, stem).message, "The map is empty: there is nothing to save.");
  EXPECT_THAT(saveMap({{0.05, {0, 0}, 2, 2}, {0}}, stem).message, HasSubstr("has 1 cells"));
  EXPECT_THAT(saveMap({{std::nan(""), {0, 0}, 1, 1}, {0}}, stem).message,
              HasSubstr("not a number"));
  EXPECT_THAT(
      saveMap({{0.05, {std::numeric_limits<double>::infinity(), 0}, 1, 1}, {0}}, stem).message,
      HasSubstr("not a number"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(MapFileHostile, SaveTellsTheTruthAboutTheDisk) {
  const test::TemporaryFolder folder;
  const OccupancyGrid map{{0.05, {0, 0}, 1, 1}, {0}};
  folder.write("file", "not a folder");
  const SaveResult none = saveMap(map, folder.path() / "file" / "map");
  EXPECT_FALSE(none.success);
  EXPECT_THAT(none.message, HasSubstr("file/map.pgm could not be written"));
  EXPECT_TRUE(none.paths.empty());

  fs::create_directory(folder.path() / "map.yaml");  // in the way of the second file
  const SaveResult half = saveMap(map, folder.path() / "map");
  EXPECT_FALSE(half.success);
  EXPECT_THAT(half.message, HasSubstr("map.yaml could not be written: Is a directory."));
  ASSERT_EQ(half.paths.size(), 1U);
  EXPECT_EQ(half.paths[0].filename(), "map.pgm");
}

}  // namespace
}  // namespace omega_slam::grid
