#include "omega_slam/config/yaml_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam::config {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class HostileYamlFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string write(const std::string& text) const {
    const std::string path = folder_ / "slam.yaml";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  [[nodiscard]] static std::string faultOf(const std::string& path) {
    try {
      (void)loadYamlFile(path);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(HostileYamlFile, MissingFileIsNamedWithTheCause) {
  EXPECT_THAT(faultOf(folder_ / "none.yaml"),
              MatchesRegex(".*none.yaml: can't be read: No such file or directory\\."));
}

TEST_F(HostileYamlFile, FolderIsNotAFile) {
  EXPECT_THAT(faultOf(folder_), HasSubstr("this is a folder, not a file."));
}

TEST_F(HostileYamlFile, EmptyFileIsAFault) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~\n"}) {
    EXPECT_THAT(faultOf(write(text)), HasSubstr("slam.yaml: the file is empty.")) << text;
  }
}

TEST_F(HostileYamlFile, SeveralDocumentsAreAFault) {
  EXPECT_THAT(faultOf(write("a: 1\n---\nb: 2\n")), HasSubstr("the file holds 2 documents"));
}

TEST_F(HostileYamlFile, SyntaxErrorSaysTheLine) {
  EXPECT_THAT(faultOf(write("a: 1\nb: [1, 2\nc: 3\n")),
              MatchesRegex(".*slam.yaml:3: this is not YAML: .*\\."));
  EXPECT_THAT(faultOf(write("a: 1\n\tb: 2\n")), HasSubstr("slam.yaml:2: this is not YAML"));
  EXPECT_THAT(faultOf(write("a: *nobody\n")), HasSubstr("slam.yaml:1: this is not YAML"));
}

TEST_F(HostileYamlFile, DeepNestingIsAFaultAndNotACrash) {
  EXPECT_THAT(faultOf(write(std::string(100000, '['))), HasSubstr("this is not YAML"));
}

TEST_F(HostileYamlFile, BinaryIsRefusedByTheReaderAtTheLatest) {
  const std::string path =
      write(std::string("\x7f"
                        "ELF\0\x01\x02\xff\xfe",
                        9));
  EXPECT_THROW(ParameterReader(loadYamlFile(path), "", path).finish(), ConfigurationError);
}

TEST_F(HostileYamlFile, GroupThatHoldsItselfIsReadToItsEnd) {
  ParameterReader reader(loadYamlFile(write("icp: &icp\n  i: 3\n  icp: *icp\n")), "", "slam.yaml");
  int i = 0;
  reader.group("icp").read("i", i);
  EXPECT_EQ(i, 3);
  EXPECT_THROW(reader.finish(), ConfigurationError);
}

TEST_F(HostileYamlFile, KeysThatAreNotTextAreUnknown) {
  ParameterReader reader(loadYamlFile(write("? [a, b]\n: 1\n? {c: d}\n: 2\n")), "", "slam.yaml");
  int i = 0;
  reader.read("a", i);
  EXPECT_THROW(reader.finish(), ConfigurationError);
}

TEST_F(HostileYamlFile, EndlessNumberIsText) {
  ParameterReader reader(loadYamlFile(write("a: " + std::string(1000000, '1') + "\n")), "", "");
  double a = 0.5;
  reader.read("a", a);
  EXPECT_THROW(reader.finish(), ConfigurationError);
  EXPECT_EQ(a, 0.5);
}

}  // namespace
}  // namespace omega_slam::config
