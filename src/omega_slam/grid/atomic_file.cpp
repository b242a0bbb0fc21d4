#include "omega_slam/grid/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace omega_slam::grid {
namespace {

namespace fs = std::filesystem;

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int get() const { return value_; }
  [[nodiscard]] bool isOpen() const { return value_ >= 0; }
  /// @return 0, or what close(2) failed with (network file systems report lost writes here)
  int close() {
    if (value_ < 0) {
      return 0;
    }
    const int result = ::close(value_);
    value_ = -1;
    return result == 0 ? 0 : errno;
  }

 private:
  int value_;
};

std::string cause(int error) { return std::generic_category().message(error); }

std::string sentence(const fs::path& path, const std::string& why) {
  return fmt::format("{} could not be written: {}.", path.string(), why);
}

/// A file that did not exist before, beside the one that it will replace. Its mode is what a plain
/// open would give, which mkstemp's is not. The name is tried again while others hold it.
int openTemporary(const fs::path& target, fs::path& temporary) {
  constexpr int kAttempts = 100;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    temporary = target.parent_path() /
                fmt::format(".{}.{}.{}.tmp", target.filename().string(), ::getpid(), attempt);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) {
      return descriptor;
    }
  }
  return -1;
}

/// @return 0 or errno
int writeAll(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    content.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0U);
  }
  return 0;
}

/// The rename itself reaches the disk only with the folder. @return 0 or errno
int syncFolder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.isOpen()) {
    // A folder may be writable but not readable: then there is nothing that we could sync.
    return errno == EACCES ? 0 : errno;
  }
  // Some file systems cannot sync a folder and say so with EINVAL; they do it in their own time.
  return ::fsync(descriptor.get()) == 0 || errno == EINVAL ? 0 : errno;
}

/// @return 0 or errno; closes the descriptor
int fill(Descriptor& file, std::string_view content) {
  const int written = writeAll(file.get(), content);
  const int synced = written == 0 && ::fsync(file.get()) != 0 ? errno : 0;
  const int closed = file.close();
  return written != 0 ? written : (synced != 0 ? synced : closed);
}

/// @return 0 or errno
int replaceFile(const fs::path& target, std::string_view content) {
  fs::path temporary;
  Descriptor file(openTemporary(target, temporary));
  if (!file.isOpen()) {
    return errno;
  }
  int failure = fill(file, content);
  if (failure == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) {
    failure = errno;
  }
  if (failure != 0) {
    ::unlink(temporary.c_str());
    return failure;
  }
  return syncFolder(target.parent_path());
}

/// @param target a device or a pipe: what it takes in is gone, and a rename would put it out of the
/// way
/// @return 0 or errno
int writeInto(const fs::path& target, std::string_view content) {
  Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.isOpen()) {
    return errno;
  }
  const int written = writeAll(file.get(), content);
  const int closed = file.close();
  return written != 0 ? written : closed;
}

/// The file that is meant: a link stays one.
fs::path targetOf(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::absolute(path, error);
  return fs::is_symlink(target, error) ? fs::weakly_canonical(target, error) : target;
}

}  // namespace

std::string writeFileAtomically(const fs::path& path, std::string_view content) {
  if (path.filename().empty()) {
    return sentence(path, "the path names no file");
  }
  const fs::path target = targetOf(path);
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  if (error) {
    return sentence(path, fmt::format("its folder could not be made: {}", error.message()));
  }
  const int failure =
      fs::is_other(target, error) ? writeInto(target, content) : replaceFile(target, content);
  return failure == 0 ? std::string() : sentence(path, cause(failure));
}

std::string readFile(const fs::path& path) {
  const auto fail = [&path](const std::string& why) {
    return std::runtime_error(fmt::format("{} could not be read: {}.", path.string(), why));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.isOpen()) {
    throw fail(cause(errno));
  }
  std::string content;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer, sizeof(buffer));
    if (count == 0) {
      return content;
    }
    if (count < 0 && errno != EINTR) {
      throw fail(cause(errno));
    }
    content.append(buffer, count > 0 ? static_cast<std::size_t>(count) : 0U);
  }
}

}  // namespace omega_slam::grid
