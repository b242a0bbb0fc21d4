#include "omega_slam/grid/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFile, WritesAndReadsBytesAsTheyAre) {
  const test::TemporaryFolder folder;
  const std::string bytes("zero \0 high \xff line\r\n", 20);
  EXPECT_EQ(writeFileAtomically(folder.path() / "a.bin", bytes), "");
  EXPECT_EQ(readFile(folder.path() / "a.bin"), bytes);
}

TEST(AtomicFile, EmptyContentMakesAnEmptyFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(writeFileAtomically(folder.path() / "a", ""), "");
  EXPECT_EQ(fs::file_size(folder.path() / "a"), 0U);
}

TEST(AtomicFile, MakesFoldersAndLeavesOnlyTheFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(writeFileAtomically(folder.path() / "a" / "b" / "c.txt", "x"), "");
  EXPECT_EQ(
      std::distance(fs::directory_iterator(folder.path() / "a" / "b"), fs::directory_iterator()),
      1);
}

TEST(AtomicFile, TakesARelativePath) {
  const test::TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_EQ(writeFileAtomically("plain.txt", "x"), "");
  fs::current_path(before);
  EXPECT_EQ(readFile(folder.path() / "plain.txt"), "x");
}

TEST(AtomicFile, ModeFollowsTheUmask) {
  const test::TemporaryFolder folder;
  const mode_t before = ::umask(027);
  EXPECT_EQ(writeFileAtomically(folder.path() / "a", "x"), "");
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder.path() / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(AtomicFile, ALinkStaysOne) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "kept");
  const fs::path file = folder.write("kept/map.pgm", "old");
  const fs::path link = folder.path() / "newest.pgm";
  fs::create_symlink("kept/map.pgm", link);
  EXPECT_EQ(writeFileAtomically(link, "new"), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(readFile(file), "new");
}

TEST(AtomicFile, APipeIsWrittenInto) {
  const test::TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(writeFileAtomically(pipe, "through"), "");
  char content[16] = {};
  EXPECT_EQ(::read(reader, content, sizeof(content)), 7);
  ::close(reader);
  EXPECT_STREQ(content, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace omega_slam::grid
