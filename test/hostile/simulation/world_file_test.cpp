#include "omega_slam/simulation/world_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/temporary_folder.h"

namespace omega_slam::simulation {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

const std::string kGood = "map: room.yaml\ndescription: A room.\nstart: [1, 2, 0.5]\n";

const std::string kMapYaml =
    "image: room.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// What is said of a world file with this content; empty if nothing is wrong with it.
std::string complaint(const std::string& content) {
  const test::TemporaryFolder folder;
  folder.write("room.yaml", kMapYaml);
  folder.write("room.pgm", std::string("P5\n2 1\n255\n") + '\0' + '\xfe');
  const auto path = folder.write("room.world.yaml", content);
  try {
    (void)loadWorld(path);
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("room.world.yaml"));
    return error.what();
  }
  return {};
}

TEST(WorldFile, ReadsWhatIsThere) {
  const test::TemporaryFolder folder;
  folder.write("room.yaml", kMapYaml);
  folder.write("room.pgm", std::string("P5\n2 1\n255\n") + '\0' + '\xfe');
  const LoadedWorld loaded =
      loadWorld(folder.write("room.world.yaml", kGood + "route:\n  - [1, 2.5]\n  - [-3, 4]\n"));
  EXPECT_EQ(loaded.file.description, "A room.");
  EXPECT_EQ(loaded.file.start.vector(), Eigen::Vector3d(1.0, 2.0, 0.5));
  ASSERT_EQ(loaded.file.route.size(), 2U);
  EXPECT_EQ(loaded.file.route[1], Eigen::Vector2d(-3.0, 4.0));
  EXPECT_EQ(loaded.world->at({0, 0}), Material::kWall);
  EXPECT_EQ(loaded.world->at({1, 0}), Material::kNone);
}

TEST(WorldFile, ARouteMayBeAbsent) { EXPECT_EQ(complaint(kGood), ""); }

TEST(WorldFile, NamesTheKeyThatIsMissing) {
  EXPECT_THAT(complaint("description: x\nstart: [0, 0, 0]\n"), HasSubstr("lacks the key 'map'"));
  EXPECT_THAT(complaint("map: room.yaml\nstart: [0, 0, 0]\n"),
              HasSubstr("lacks the key 'description'"));
  EXPECT_THAT(complaint("map: room.yaml\ndescription: x\n"), HasSubstr("lacks the key 'start'"));
}

TEST(WorldFile, NamesTheKeyThatIsUnknown) {
  EXPECT_THAT(complaint(kGood + "strat: [0, 0, 0]\n"),
              AllOf(HasSubstr("unknown key 'strat'"), HasSubstr("start")));
}

TEST(WorldFile, NamesTheKeyOfAWrongValue) {
  const std::string head = "map: room.yaml\ndescription: x\n";
  for (const std::string start :
       {"[0, 0]", "[0, 0, 0, 0]", "[0, zero, 0]", "[0, .nan, 0]", "[0, .inf, 0]", "[0, '1', 0]",
        "5", "{x: 0}", "", "[[0], 0, 0]"}) {
    EXPECT_THAT(complaint(head + "start: " + start + "\n"),
                AllOf(HasSubstr("3 finite numbers"), HasSubstr("'start'")))
        << start;
  }
  EXPECT_THAT(complaint("map: [a]\ndescription: x\nstart: [0, 0, 0]\n"), HasSubstr("'map'"));
  EXPECT_THAT(complaint("map:\ndescription: x\nstart: [0, 0, 0]\n"), HasSubstr("'map'"));
}

TEST(WorldFile, NamesTheWaypointThatIsWrong) {
  EXPECT_THAT(complaint(kGood + "route: [[0, 0], [1]]\n"), HasSubstr("'route[1]'"));
  EXPECT_THAT(complaint(kGood + "route: [[0, .nan]]\n"), HasSubstr("'route[0]'"));
  EXPECT_THAT(complaint(kGood + "route: 7\n"), HasSubstr("'route'"));
  EXPECT_THAT(complaint(kGood + "route:\n"), HasSubstr("'route'"));
}

TEST(WorldFile, SaysWhenItIsNoWorldFileAtAll) {
  EXPECT_THAT(complaint(""), HasSubstr("does not hold keys"));
  EXPECT_THAT(complaint("- a\n- b\n"), HasSubstr("does not hold keys"));
  EXPECT_THAT(complaint("map: [\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(complaint("? [a, b]\n: 1\n"), HasSubstr("world.yaml"));
  EXPECT_THAT(complaint(std::string("\x00\xff\xfe\x01", 4)), HasSubstr("world.yaml"));
}

TEST(WorldFile, SaysWhenItCannotBeOpened) {
  try {
    (void)loadWorld("/nowhere/at_all.world.yaml");
    FAIL() << "a world that is not there was loaded";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("/nowhere/at_all.world.yaml"), EndsWith("cannot be opened.")));
  }
}

TEST(WorldFile, NamesItselfAndTheMapThatIsMissing) {
  EXPECT_THAT(complaint("map: gone.yaml\ndescription: x\nstart: [0, 0, 0]\n"),
              AllOf(HasSubstr("its map cannot be used"), HasSubstr("gone.yaml")));
}

}  // namespace
}  // namespace omega_slam::simulation
