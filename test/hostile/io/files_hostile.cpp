#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "omega_slam/io/carmen_log.h"
#include "omega_slam/io/trajectory_file.h"
#include "support/seeds.h"
#include "support/temporary_folder.h"

namespace omega_slam::io {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

template <typename Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

constexpr const char* kGood = "FLASER 2 1 2 0 0 0 1 2 3 4.5 host 5\n";

TEST(CarmenLogHostile, MalformedLinesAreCountedAndPassedOver) {
  const char* const bad[] = {
      "FLASER ",
      "FLASER two 1 2 0 0 0 1 2 3 4.5 host 5",
      "FLASER 0 0 0 0 1 2 3 4.5 host 5",
      "FLASER -1 1 2 0 0 0 1 2 3 4.5 host 5",
      "FLASER 1.5 1 2 0 0 0 1 2 3 4.5 host 5",
      "FLASER 999999999999 1 2 0 0 0 1 2 3 4.5 host 5",
      "FLASER 1000 1 2 0 0 0 1 2 3 4.5 host 5",
      "FLASER 2 1 2 0 0 0 1 2",
      "FLASER 2 1 2 0 0 0 1 2 3",
      "FLASER 2 1 2 0 0 0 nan 2 3 4.5 host 5",
      "FLASER 2 1 2 0 0 0 1 inf 3 4.5 host 5",
      "FLASER 2 1 2 0 0 0 1 2 3 soon host 5",
  };
  for (const char* line : bad) {
    const CarmenLog log = parseCarmenLog(std::string(kGood) + line + "\n" + kGood, "log");
    EXPECT_EQ(log.records.size(), 2U) << line;
    EXPECT_EQ(log.malformed_lines, 1U) << line;
    EXPECT_THAT(log.first_fault, ::testing::StartsWith("line 2: ")) << line;
  }
}

TEST(CarmenLogHostile, TheFirstFaultIsKept) {
  const CarmenLog log =
      parseCarmenLog(std::string(kGood) + "\nFLASER 2 1 2 0 0 0 1 2 x 4\nFLASER x\n", "log");
  EXPECT_EQ(log.malformed_lines, 2U);
  EXPECT_EQ(log.first_fault, "line 3: the odometry is not a finite number");
}

TEST(CarmenLogHostile, FilesWithoutALaser) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(complaint([&] { (void)readCarmenLog(folder.path() / "absent.clf"); }),
              HasSubstr("absent.clf could not be read: No such file or directory."));
  EXPECT_THAT(complaint([&] { (void)readCarmenLog(folder.path()); }), HasSubstr("Is a directory"));
  for (const char* text : {"", "\n\n", "ODOM 1 2 3\n", "FLASERX 1 1\n", "#FLASER 2 1 2\n"}) {
    EXPECT_EQ(complaint([&] { (void)readCarmenLog(folder.write("a.clf", text)); }),
              (folder.path() / "a.clf").string() +
                  ": no usable laser message (FLASER or ROBOTLASER1) is in it.")
        << text;
  }
  EXPECT_EQ(complaint([] { (void)parseCarmenLog("FLASER 0 1\n", "log"); }),
            "log: no usable laser message (FLASER or ROBOTLASER1) is in it; 1 are malformed, first "
            "line 1: the scan has no beams.");
}

TEST(CarmenLogHostile, OptionsAreChecked) {
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    CarmenLogOptions options;
    options.no_return_range = bad;
    EXPECT_THROW((void)parseCarmenLog(kGood, "log", options), std::invalid_argument);
  }
}

TEST(CarmenLogHostile, DamagedBytesNeverDoWorseThanAnError) {
  for (const std::uint64_t seed : test::seeds()) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 1000; ++trial) {
      std::string text = std::string(kGood) + kGood;
      for (int change = 0; change < 4; ++change) {
        text[random() % text.size()] = static_cast<char>(random() % 256);
      }
      try {
        for (const CarmenRecord& record : parseCarmenLog(text, "log").records) {
          ASSERT_TRUE(record.T_odom_base.isFinite());
          ASSERT_TRUE(std::isfinite(record.scan.stamp));
          ASSERT_FALSE(record.scan.ranges.empty());
        }
      } catch (const std::runtime_error& error) {
        ASSERT_THAT(error.what(), HasSubstr("log: "));
      }
    }
  }
}

TEST(TrajectoryFileHostile, FaultsNameFileLineAndReason) {
  const test::TemporaryFolder folder;
  const std::string good = "1 0 0 0 0 0 0 1\n";
  const std::pair<const char*, const char*> rows[] = {
      {"2 0 0 0 0 0 1", "7 numbers where 8 are expected (stamp x y z qx qy qz qw)."},
      {"2 0 0 0 0 0 0 1 5", "9 numbers where 8 are expected"},
      {"2 0 0 0 0 0 0 one", "'one' is not a finite number"},
      {"2 0 0 0 0 0 0 nan", "'nan' is not a finite number"},
      {"2 0 0 0 0 0 0 0", "the quaternion is not of unit length"},
      {"2 0 0 0 0 0 2 1", "the quaternion is not of unit length"},
  };
  for (const auto& [line, says] : rows) {
    const fs::path path = folder.write("t.tum", good + line + "\n");
    const std::string said = complaint([&path] { (void)readTrajectory(path); });
    EXPECT_THAT(said, ::testing::StartsWith(path.string() + ":2: ")) << line;
    EXPECT_THAT(said, HasSubstr(says)) << line;
  }
}

TEST(TrajectoryFileHostile, EmptyAndMissingFiles) {
  const test::TemporaryFolder folder;
  const fs::path empty = folder.write("e", "# nothing\n");
  EXPECT_EQ(complaint([&] { (void)readTrajectory(empty); }),
            empty.string() + ": no line of numbers is in it.");
  EXPECT_EQ(complaint([&] { (void)readOdometry(empty); }),
            empty.string() + ": no line of numbers is in it.");
  EXPECT_THAT(complaint([&] { (void)readRelations(folder.path() / "absent"); }),
              HasSubstr("absent could not be read: No such file or directory."));
  EXPECT_THAT(complaint([&] { (void)readOdometry(folder.write("o", "1 2 3\n")); }),
              HasSubstr(":1: 3 numbers where 4 are expected (stamp x y theta)."));
}

}  // namespace
}  // namespace omega_slam::io
