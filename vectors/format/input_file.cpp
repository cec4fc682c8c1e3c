// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/input_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "golden/input_error.h"

namespace cbvh::vectors {
namespace {

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

[[noreturn]] void fail(const std::string& path) {
  throw golden::InputError(path, fmt::format("cannot read: {}", std::strerror(errno)));
}

}  // namespace

InputFile::InputFile(const std::string& path) {
  const Descriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  struct stat status {};
  if (file.number < 0 || fstat(file.number, &status) != 0) fail(path);
  if (S_ISDIR(status.st_mode)) throw golden::InputError(path, "cannot read: it is a directory");
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapping = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (mapping != MAP_FAILED) {
      madvise(mapping, size, MADV_SEQUENTIAL);
      mapped_ = true;
      bytes_ = {static_cast<const char*>(mapping), size};
      return;
    }
  }
  char chunk[1 << 16];
  for (;;) {
    const ssize_t got = read(file.number, chunk, sizeof chunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path);
    if (got == 0) break;
    read_.append(chunk, static_cast<std::size_t>(got));
  }
  bytes_ = read_;
}

InputFile::~InputFile() {
  if (mapped_) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace cbvh::vectors
