#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string>
#include <thread>

#include "omega_slam/grid/atomic_file.h"
#include "support/temporary_folder.h"

namespace omega_slam::grid {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Lets files grow to so many bytes only, as a full disk would.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

/// Root may write anywhere: become somebody else for a while.
class Unprivileged {
 public:
  Unprivileged() : root_(::geteuid() == 0 && ::seteuid(65534) == 0) {}
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;
  ~Unprivileged() {
    if (root_) {
      static_cast<void>(::seteuid(0) == 0);
    }
  }

 private:
  bool root_;
};

TEST(AtomicFileHostile, FullDiskLeavesTheOldFileAndNothingElse) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("map.pgm", "old");
  std::string said;
  {
    const SmallDisk disk(4096);
    said = writeFileAtomically(file, std::string(100000, 'x'));
  }
  EXPECT_EQ(said, file.string() + " could not be written: File too large.");
  EXPECT_EQ(readFile(file), "old");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFileHostile, ADeviceThatIsFullSaysSoAndStays) {
  const test::TemporaryFolder folder;
  const fs::path link = folder.path() / "map.pgm";
  fs::create_symlink("/dev/full", link);
  EXPECT_EQ(writeFileAtomically(link, "x"),
            link.string() + " could not be written: No space left on device.");
  EXPECT_TRUE(fs::is_character_file(link));
}

TEST(AtomicFileHostile, ReadOnlyFolder) {
  const test::TemporaryFolder folder;
  const fs::path locked = folder.path() / "locked";
  fs::create_directory(locked);
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                              fs::perms::others_exec);
  std::string direct;
  std::string below;
  {
    const Unprivileged somebody;
    direct = writeFileAtomically(locked / "map.pgm", "x");
    below = writeFileAtomically(locked / "new" / "map.pgm", "x");
  }
  EXPECT_EQ(direct, (locked / "map.pgm").string() + " could not be written: Permission denied.");
  EXPECT_THAT(below, HasSubstr("its folder could not be made: Permission denied"));
  EXPECT_EQ(entries(locked), 0U);
}

TEST(AtomicFileHostile, OddPaths) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(writeFileAtomically("", "x"), HasSubstr("the path names no file"));
  EXPECT_THAT(writeFileAtomically(folder.path() / "", "x"), HasSubstr("the path names no file"));
  EXPECT_THAT(writeFileAtomically(folder.path() / std::string(300, 'n'), "x"),
              HasSubstr("File name too long"));
  fs::create_directory(folder.path() / "taken");
  EXPECT_THAT(writeFileAtomically(folder.path() / "taken", "x"), HasSubstr("Is a directory"));
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFileHostile, ATemporaryLeftByACrashIsNoObstacle) {
  const test::TemporaryFolder folder;
  const std::string left = "." + std::string("a.txt.") + std::to_string(::getpid()) + ".0.tmp";
  folder.write(left, "rubbish");
  EXPECT_EQ(writeFileAtomically(folder.path() / "a.txt", "new"), "");
  EXPECT_EQ(readFile(folder.path() / "a.txt"), "new");
}

TEST(AtomicFileHostile, ReadersNeverSeeAPart) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", std::string(200000, 'a'));
  std::atomic<bool> done{false};
  std::string failure;
  std::thread writer([&] {
    for (int round = 0; round < 30 && failure.empty(); ++round) {
      failure = writeFileAtomically(file, std::string(200000, round % 2 == 0 ? 'b' : 'a'));
    }
    done = true;
  });
  while (!done) {
    const std::string seen = readFile(file);
    EXPECT_EQ(seen, std::string(200000, seen.empty() ? '?' : seen[0]));
  }
  writer.join();
  EXPECT_EQ(failure, "");
}

}  // namespace
}  // namespace omega_slam::grid
