// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "golden/input_error.h"

namespace cbvh::vectors {

Output::Output(const File& file) : path_(file.path) {
  struct stat status {};
  if (stat(path_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    throw golden::InputError(path_, "cannot write: it exists and is not a regular file");
  }
  temporary_ = fmt::format("{}.{}.tmp", path_, getpid());
  file_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail("write");
}

Output::~Output() {
  if (file_ < 0) return;
  close(file_);
  unlink(temporary_.c_str());
}

void Output::fail(const char* action) {
  throw golden::InputError(path_, fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

std::uint32_t Output::crc() {
  flush();
  return crc_.value();
}

void Output::flush() {
  crc_.update({buffer_.data(), buffer_.size()});
  if (text_ != nullptr) {
    text_->append(buffer_.data(), buffer_.size());
  } else {
    for (std::size_t done = 0; done < buffer_.size();) {
      const ssize_t wrote = write(file_, buffer_.data() + done, buffer_.size() - done);
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote < 0) fail("write");
      done += static_cast<std::size_t>(wrote);
    }
  }
  buffer_.clear();
}

void Output::commit() {
  flush();
  if (text_ != nullptr) return;
  if (fsync(file_) != 0) fail("write");
  const int file = file_;
  file_ = -1;
  if (close(file) != 0 || rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int reason = errno;
    unlink(temporary_.c_str());
    errno = reason;
    fail("write");
  }
}

}  // namespace cbvh::vectors
