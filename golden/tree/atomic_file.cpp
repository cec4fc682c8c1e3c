// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

/// A new file beside `path` that is removed unless it was renamed to it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : target(path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
      throw InputError(path, "cannot be written: it exists and is not a regular file");
    static std::atomic<unsigned> serial{0};
    name = fmt::format("{}.{}-{}.tmp", path, getpid(), serial++);
    descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor >= 0) close(descriptor);
    if (!renamed) unlink(name.c_str());
  }

  void write_all(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = write(descriptor, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  void become_target() {
    if (fsync(descriptor) != 0) fail();
    if (close(std::exchange(descriptor, -1)) != 0) fail();
    if (std::rename(name.c_str(), target.c_str()) != 0) fail();
    renamed = true;
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(target, fmt::format("cannot be written: {}", std::strerror(errno)));
  }

  std::string target;
  std::string name;
  int descriptor = -1;
  bool renamed = false;
};

/// Makes the rename last. A file system that cannot is no reason to fail: the file is complete either way.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

void write_file_atomically(const std::string& path, std::string_view bytes) {
  TemporaryFile file(path);
  file.write_all(bytes);
  file.become_target();
  sync_folder_of(path);
}

}  // namespace cbvh::golden
